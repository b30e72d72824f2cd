#pragma once

#include <string>
#include <string_view>

namespace abrazo::app {

/// "view_layouts.save_layout" of "View > Layouts" and "Save layout…": what an action is kept and found under,
/// also when it changes its words.
std::string action_id(std::string_view menu, std::string_view text);

}  // namespace abrazo::app
