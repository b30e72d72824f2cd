#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace abrazo {

/// A point's name without the words for its side.
struct SidedName {
  std::string word;
  int side = 0;  ///< +1 left, -1 right, 0 neither
};

/// "Bip01 L UpperArm" -> bip01, l, upper, arm: small letters and digits, without a namespace.
std::vector<std::string> name_parts(std::string_view name);

SidedName sided_name(const std::vector<std::string>& parts);
SidedName sided_name(std::string_view name);

}  // namespace abrazo
