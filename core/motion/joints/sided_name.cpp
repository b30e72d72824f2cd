#include "core/motion/joints/sided_name.hpp"

#include <cctype>
#include <utility>

namespace abrazo {

std::vector<std::string> name_parts(std::string_view name) {
  if (const auto colon = name.rfind(':'); colon != std::string_view::npos) name.remove_prefix(colon + 1);
  std::vector<std::string> parts(1);
  std::size_t begin = 0;  // of the current word between marks
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    const bool breaks = !std::isalnum(c) ||
                        (i > 0 && std::isupper(c) && std::islower(static_cast<unsigned char>(name[i - 1])));
    if (!std::isalnum(c)) begin = i + 1;
    const bool second_capital = i == begin + 1 && std::isupper(c) && i + 1 < name.size() &&
                                (name[begin] == 'L' || name[begin] == 'R');
    if ((breaks || second_capital) && !parts.back().empty()) parts.emplace_back();
    if (std::isalnum(c)) parts.back() += static_cast<char>(std::tolower(c));
  }
  return parts;
}

SidedName sided_name(const std::vector<std::string>& parts) {
  SidedName result;
  for (const std::string& part : parts) {
    const int side = part == "l" || part == "left" || part == "lft"    ? 1
                     : part == "r" || part == "right" || part == "rgt" ? -1
                                                                       : 0;
    if (side != 0 && result.side == 0)
      result.side = side;
    else
      result.word += part;
  }
  for (const auto& [word, side] : {std::pair<std::string, int>("left", 1), {"right", -1}})
    if (result.side == 0 && result.word.starts_with(word))
      result.side = side, result.word.erase(0, word.size());
  return result;
}

SidedName sided_name(std::string_view name) {
  return sided_name(name_parts(name));
}

}  // namespace abrazo
