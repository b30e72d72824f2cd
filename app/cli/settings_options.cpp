#include "app/cli/settings_options.hpp"

#include "core/base/text.hpp"

namespace abrazo::app {

void SettingsOptions::add_to(CLI::App& command) {
  command.add_option("--preset", preset_, "paper (the paper's letter) or responsive (small lag, few jumps)")
      ->group("Settings")
      ->check(CLI::IsMember({"paper", "responsive"}))
      ->capture_default_str();
  for (const SettingInfo& info : all_settings()) {
    const std::string key(info.key);
    std::string names = "--" + key;
    if (key == "neighbours") names = "-k," + names;
    std::string help(info.help);
    const auto add = [&](const std::string& text) { help += " [" + text + "]"; };
    if (info.kind == SettingInfo::Kind::Flag)
      add("on|off");
    else if (info.kind == SettingInfo::Kind::Choice)
      add(std::string(info.choices));
    else
      add(exact_text(info.minimum) + " to " + exact_text(info.maximum) +
          (info.unit.empty() ? "" : " " + std::string(info.unit)));
    command
        .add_option_function<std::string>(
            names, [this, key](const std::string& text) { given_[key] = text; }, help)
        ->group("Settings")
        ->check([key](const std::string& text) {
          Settings scratch;
          const Status usable = set_setting(scratch, key, text);
          return usable.ok() ? std::string() : usable.error().text();
        });
  }
}

Result<Settings> SettingsOptions::read() const {
  auto settings = preset(preset_);
  if (!settings) return settings;
  for (const auto& [key, text] : given_) {
    const Status set = set_setting(*settings, key, text);
    if (!set) return set.error();
  }
  return settings;
}

}  // namespace abrazo::app
