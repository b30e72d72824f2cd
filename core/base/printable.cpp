#include "core/base/printable.hpp"

#include <cstddef>

#include "core/base/limits.hpp"

namespace abrazo {

namespace {

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x20 || byte == 0x7f;
}

/// U+0080 to U+009F, which some terminals interpret as escape sequences.
bool is_control_of_two_bytes(std::string_view text) {
  return text.size() >= 2 && text[0] == '\xC2' && static_cast<unsigned char>(text[1]) >= 0x80 &&
         static_cast<unsigned char>(text[1]) < 0xA0;
}

std::string without_controls(std::string_view text, std::string_view but_for) {
  std::string shown;
  shown.reserve(text.size());
  for (; !text.empty(); text.remove_prefix(1)) {
    if (is_control_of_two_bytes(text)) {
      text.remove_prefix(1);
      shown += '?';
    } else if (is_control(text.front()) && but_for.find(text.front()) == std::string_view::npos) {
      shown += '?';
    } else {
      shown += text.front();
    }
  }
  return shown;
}

}  // namespace

std::string printable(std::string_view text) {
  return without_controls(text, "\n\t");
}

std::string printable_line(std::string_view text) {
  if (text.size() <= limits::line_bytes) return without_controls(text, "");
  std::size_t end = limits::line_bytes;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80) --end;  // within a character
  return without_controls(text.substr(0, end), "") + "... (" + std::to_string(text.size()) + " bytes)";
}

}  // namespace abrazo
