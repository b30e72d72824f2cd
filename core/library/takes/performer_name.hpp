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
  std::size_t begin = 0;  ///< place in the name
  std::size_t size = 0;
};
std::vector<NamePart> parts_of_name(std::string_view name);

/// How the names of two performers of one take may differ.
enum class NameContrast {
  None,     ///< nothing that tells two performers apart
  Words,    ///< any two words: anna, ben
  Numbers,  ///< numbers of subjects: 60, 61
  Letters,  ///< a, b
  Roles     ///< leader, follower; attacker, defender; ...
};

/// What two names differ in, where everything else of them is alike.
struct NameDifference {
  NameContrast contrast = NameContrast::None;
  std::size_t part = 0;         ///< index into the parts of the first
  std::string first, second;    ///< what stands there: "60", "61"
  bool first_is_active = true;  ///< meaningful with Roles
  bool one_more_part = false;   ///< the second says more at its end: "take1", "take1_partner"
};

/// @return nothing when they are equal or differ in more than a pair's names would
std::optional<NameDifference> difference_of_names(std::string_view first, std::string_view second);

/// What the two names share, as it stands in the first: "take1" of take1_leader and take1_follower. May be
/// empty.
std::string shared_name(std::string_view first, const NameDifference& difference);

}  // namespace abrazo
