#include "core/base/xml_text.hpp"

namespace abrazo {

std::string xml_text(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '"')
      safe += "&quot;";
    else if (c == '\'')
      safe += "&#39;";
    else if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t')
      safe += ' ';  // control characters are not allowed in XML, not even escaped
    else
      safe += c;
  }
  return safe;
}

}  // namespace abrazo
