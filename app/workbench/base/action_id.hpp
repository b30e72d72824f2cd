#pragma once

#include <string>
#include <string_view>

namespace abrazo::app {

/// "view_layouts.save_layout" of "View > Layouts" and "Save layout…": the stable id of an action, independent
/// of later changes of its text.
std::string action_id(std::string_view menu, std::string_view text);

}  // namespace abrazo::app
