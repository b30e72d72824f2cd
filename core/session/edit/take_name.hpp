#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace abrazo {

/// "salsa 003": what the takes of a series share, and which of them it is.
struct TakeName {
  std::string stem;
  int number = 0;  ///< 0 = none was written

  bool operator==(const TakeName&) const = default;
};

/// A number of at most six digits at the end counts, with or without something between.
TakeName parse_take_name(std::string_view text);
/// At least three digits: "salsa 003".
std::string text_of(const TakeName& name);

/// The name of the next take: what was typed where its number is still free, else one above the highest of
/// the same stem. "take" where nothing was typed.
std::string next_take_name(std::string_view typed, const std::vector<std::string>& names);
/// The same stem, a number up, whatever was typed since. Empty when there is no name yet.
std::string again_name(const std::vector<std::string>& names);

}  // namespace abrazo
