#pragma once

#include <string>
#include <string_view>

namespace abrazo {

/// Text from outside (names of takes, labels) as it may stand between tags and in attributes of XML, HTML
/// and SVG.
std::string xml_text(std::string_view text);

}  // namespace abrazo
