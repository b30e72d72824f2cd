#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace abrazo {

/// "salsa 003": the stem that the takes of a series share, and the number in the series.
struct TakeName {
  std::string stem;
  int number = 0;  ///< 0 = none given

  bool operator==(const TakeName&) const = default;
};

/// The number is at most six digits at the end, with or without a separator.
TakeName parse_take_name(std::string_view text);
/// At least three digits: "salsa 003".
std::string text_of(const TakeName& name);

/// The name of the next take: the typed one if its number is free, else one above the highest number of the
/// same stem. The stem is "take" if nothing was typed.
std::string next_take_name(std::string_view typed, const std::vector<std::string>& names);
/// The stem of the last take with the next number, whatever was typed since. Empty if there is no take yet.
std::string again_name(const std::vector<std::string>& names);

}  // namespace abrazo
