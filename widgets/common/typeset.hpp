#pragma once

#include <string>
#include <string_view>

namespace abrazo::widgets {

/// A line of plain mathematics as HTML: letters and digits, or a group in braces, after '_' become
/// subscripts: in "w_Δ E_V(V_{i-1})" the Δ, the V and the i-1.
std::string typeset(std::string_view line);

/// Text escaped for HTML.
std::string escaped_html(std::string_view text);

}  // namespace abrazo::widgets
