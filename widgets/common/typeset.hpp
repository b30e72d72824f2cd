#pragma once

#include <string>
#include <string_view>

namespace abrazo::widgets {

/// A line of plain mathematics as HTML: what follows '_', a run of letters and digits or a group in braces,
/// is set low: in "w_Δ E_V(V_{i-1})" the Δ, the V and the i-1.
std::string typeset(std::string_view line);

/// Text that is to appear in HTML as it is.
std::string escaped_html(std::string_view text);

}  // namespace abrazo::widgets
