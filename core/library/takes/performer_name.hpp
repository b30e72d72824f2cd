#pragma once

#include <optional>
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
  None,     ///< nothing that distinguishes two performers
  Words,    ///< any two words: anna, ben
  Numbers,  ///< numbers of subjects: 60, 61
  Letters,  ///< a, b
  Roles     ///< leader, follower; attacker, defender; ...
};

/// The one difference between two otherwise equal names.
struct NameDifference {
  NameContrast contrast = NameContrast::None;
  std::size_t part = 0;         ///< index into the parts of the first
  std::string first, second;    ///< differing text: "60", "61"
  bool first_is_active = true;  ///< meaningful with Roles
  bool one_more_part = false;   ///< the second has an additional part at its end: "take1", "take1_partner"
};

/// @return none if they are equal or differ in more than names of a pair would
std::optional<NameDifference> difference_of_names(std::string_view first, std::string_view second);

/// The common part of two names, as written in the first: "take1" of take1_leader and take1_follower. May be
/// empty.
std::string shared_name(std::string_view first, const NameDifference& difference);

}  // namespace abrazo
