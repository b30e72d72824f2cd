#pragma once

#include <string>
#include <string_view>

namespace abrazo {

/// The text for a terminal: control characters, of which a file's own names may be full, become '?'; line
/// ends and tabs stay.
std::string printable(std::string_view text);

}  // namespace abrazo
