#pragma once

#include <string>
#include <string_view>

namespace abrazo {

/// External text (names of takes, labels) escaped for content and attributes of XML, HTML and SVG.
std::string xml_text(std::string_view text);

}  // namespace abrazo
