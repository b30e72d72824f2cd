#include <algorithm>

#include "core/evaluation/report/html_sections.hpp"

namespace abrazo {

PresetDifference nearest_preset(const Settings& settings) {
  PresetDifference nearest;
  for (const std::string_view name : preset_names) {
    PresetDifference difference{std::string(name), {}};
    for (const SettingInfo& info : all_settings())
      if (setting_text(*preset(name), info.key) != setting_text(settings, info.key))
        difference.keys.emplace_back(info.key);
    if (nearest.preset.empty() || difference.keys.size() < nearest.keys.size())
      nearest = std::move(difference);
  }
  return nearest;
}

HtmlSection settings_section(const Settings& settings, const std::vector<std::string>& swept) {
  std::vector<std::string> columns = {"setting", "this run"};
  for (const std::string_view name : preset_names) columns.push_back("preset " + std::string(name));
  HtmlTable html("All settings, as the command line takes them.", columns);
  for (const SettingInfo& info : all_settings()) {
    const bool varies = std::find(swept.begin(), swept.end(), info.key) != swept.end();
    const std::string unit = info.unit.empty() ? "" : " (" + std::string(info.unit) + ")";
    const std::string symbol = info.symbol.empty() ? "" : ", " + std::string(info.symbol);
    std::vector<std::string> cells = {std::string(info.key) + symbol + unit,
                                      varies ? std::string("swept") : setting_text(settings, info.key)};
    for (const std::string_view name : preset_names) cells.push_back(setting_text(*preset(name), info.key));
    html.row(cells);
  }
  return {"settings", "Settings", "Settings", html.html()};
}

}  // namespace abrazo
