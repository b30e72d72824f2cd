#pragma once

#include <string>
#include <string_view>

namespace abrazo {

/// The text for a terminal: control characters, of which a file's own names may be full, become '?' (C0, DEL
/// and, in UTF-8, C1); line ends and tabs stay.
std::string printable(std::string_view text);

/// The same for what has to stay on its line: line ends and tabs become '?' as well.
std::string printable_line(std::string_view text);

}  // namespace abrazo
