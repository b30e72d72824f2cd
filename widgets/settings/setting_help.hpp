#pragma once

#include <string>
#include <string_view>

#include "core/synthesis/settings/settings.hpp"

namespace abrazo::widgets {

/// "0.5 (paper), 0.1 (responsive)"; one value if the presets agree. With the unit.
std::string preset_values(const SettingInfo& info);

/// "0 to 5 m/s"; "velocity, predicted"; "on, off".
std::string value_range(const SettingInfo& info);

/// Effect of a setting, its formula (lines of the help that begin with two blanks), origin, range and
/// presets, as HTML.
std::string setting_tooltip(const SettingInfo& info);

/// The same without markup, for screen readers.
std::string setting_description(const SettingInfo& info);

/// Every word of `wanted` occurs in key, symbol, title, group or help of the setting, ignoring case. An empty
/// text matches all.
bool matches(const SettingInfo& info, std::string_view wanted);

}  // namespace abrazo::widgets
