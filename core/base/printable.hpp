#pragma once

#include <string>
#include <string_view>

namespace abrazo {

/// The text for a terminal: control characters, which names from files may contain, become '?' (C0, DEL and,
/// in UTF-8, C1); line ends and tabs stay.
std::string printable(std::string_view text);

/// The same for a single line: line ends and tabs also become '?', and one that is longer than any of our own
/// is cut.
std::string printable_line(std::string_view text);

}  // namespace abrazo
