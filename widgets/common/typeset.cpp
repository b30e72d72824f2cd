#include "widgets/common/typeset.hpp"

#include <algorithm>
#include <cctype>

namespace abrazo::widgets {
namespace {

/// Subscripts are drawn at two thirds of the size: a larger one is requested here for readability.
constexpr std::string_view low_open = "<sub style='font-size: 16px'>";

/// Bytes at the start of `text` that are letters or digits, Greek ones included.
std::size_t word_length(std::string_view text) {
  std::size_t length = 0;
  while (length < text.size()) {
    const auto byte = static_cast<unsigned char>(text[length]);
    if (std::isalnum(byte) != 0)
      length += 1;
    else if (byte == 0xCE || byte == 0xCF)
      length += 2;
    else
      break;
  }
  return std::min(length, text.size());
}

}  // namespace

std::string escaped_html(std::string_view text) {
  std::string html;
  for (const char c : text) {
    if (c == '<')
      html += "&lt;";
    else if (c == '>')
      html += "&gt;";
    else if (c == '&')
      html += "&amp;";
    else
      html += c;
  }
  return html;
}

std::string typeset(std::string_view line) {
  std::string html;
  while (!line.empty()) {
    const std::size_t low = line.find('_');
    html += escaped_html(line.substr(0, low));
    if (low == std::string_view::npos) break;
    line.remove_prefix(low + 1);
    const bool group = line.starts_with('{') && line.find('}') != std::string_view::npos;
    const std::size_t length = group ? line.find('}') + 1 : word_length(line);
    const std::string_view index = group ? line.substr(1, length - 2) : line.substr(0, length);
    html += index.empty() ? "_" : std::string(low_open) + escaped_html(index) + "</sub>";
    line.remove_prefix(length);
  }
  return html;
}

}  // namespace abrazo::widgets
