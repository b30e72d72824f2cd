#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace abrazo {

/// A file or performer name in its parts: runs of letters (split where a capital follows a small letter) and
/// runs of digits, in lower case. "takeTwo_61b" -> take, two, 61, b.
struct NamePart {
  std::string text;
  std::size_t begin = 0;  ///< offset in the name
  std::size_t size = 0;
};
std::vector<NamePart> parts_of_name(std::string_view name);

/// How the names of two performers of one take may differ.
enum class NameContrast {
  None,        ///< nothing that distinguishes two performers: take1, take2
  Words,       ///< any two words: anna, ben
  Numbers,     ///< any two numbers: 60, 61
  Letters,     ///< any two letters: a, b
  Performers,  ///< numbers behind a word for a performer: p1, p2; C0, C1; person1, person2
  Roles        ///< leader, follower; attacker, defender; ...
};

/// The one difference between two otherwise equal names.
struct NameDifference {
  NameContrast contrast = NameContrast::None;
  std::size_t part = 0;         ///< index into the parts of the first
  std::string first, second;    ///< differing text: "60", "61"
  bool first_is_active = true;  ///< meaningful with Roles
  bool also_numbers = false;    ///< with Roles: subjects are numbered as well, s60_leader and s61_follower
  bool one_more_part = false;   ///< the second has an additional part at its end: "take1", "take1_partner"
};

/// @param first, second  parts of names, or of paths
/// @return none if they are equal or differ in more than names of a pair would
std::optional<NameDifference> difference_of_names(std::span<const NamePart> first,
                                                  std::span<const NamePart> second);

/// The common part of two names, as written in the first: "take1" of take1_leader and take1_follower, "10" of
/// 10_C0 and 10_C1, "s/x" of s/0/x and s/1/x. May be empty.
std::string shared_name(std::string_view first, const NameDifference& difference);

}  // namespace abrazo
