#include "app/workbench/base/action_id.hpp"

#include <cctype>

namespace abrazo::app {
namespace {

std::string slug(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto letter = static_cast<unsigned char>(c);
    if (letter < 128 && std::isalnum(letter) != 0)
      result += static_cast<char>(std::tolower(letter));
    else if (!result.empty() && result.back() != '_' && letter < 128)
      result += '_';
  }
  while (!result.empty() && result.back() == '_') result.pop_back();
  return result;
}

}  // namespace

std::string action_id(std::string_view menu, std::string_view text) {
  // A feature's ids are its own, wherever its menu stands.
  for (const std::string_view below : {"Timeline > Play", "Solve > Compare", "View > Plots", "View > Video"})
    if (menu.starts_with(below)) menu.remove_prefix(below.find("> ") + 2);
  if (menu == "Timeline > Lanes") menu = "Timeline";
  return slug(menu) + "." + slug(text);
}

}  // namespace abrazo::app
