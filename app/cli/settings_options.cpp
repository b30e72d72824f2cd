#include "app/cli/settings_options.hpp"

#include <fmt/core.h>

#include "core/base/text.hpp"
#include "core/bodies/chosen_body.hpp"

namespace abrazo::app {

namespace {

std::string choices_of(const SettingInfo& info) {
  if (info.kind == SettingInfo::Kind::Flag) return "on|off";
  if (info.kind == SettingInfo::Kind::Choice || info.kind == SettingInfo::Kind::Body)
    return std::string(info.choices);
  return fmt::format("{} to {}{}{}", exact_text(info.minimum), exact_text(info.maximum),
                     info.unit.empty() ? "" : " ", info.unit);
}

/// "paper 0.5, responsive 0.1", or the one value that all presets have.
std::string preset_values(const SettingInfo& info) {
  std::string text;
  bool differ = false;
  const std::string first = setting_text(*preset(preset_names.front()), info.key);
  for (const std::string_view name : preset_names) {
    const std::string value = setting_text(*preset(name), info.key);
    differ = differ || value != first;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, value);
  }
  return differ ? text : "default " + first;
}

}  // namespace

void SettingsOptions::add_to(CLI::App& command) {
  command
      .add_option("--preset", preset_,
                  "paper (exactly the published method) or responsive (small lag, few jumps)")
      ->group("Settings")
      ->check(CLI::IsMember(std::vector<std::string>(preset_names.begin(), preset_names.end())))
      ->type_name("NAME")
      ->capture_default_str();
  for (const SettingInfo& info : all_settings()) {
    const std::string key(info.key);
    const std::string names = (key == "neighbours" ? "-k,--" : "--") + key;
    const bool number = info.kind == SettingInfo::Kind::Real || info.kind == SettingInfo::Kind::Integer;
    command
        .add_option_function<std::string>(
            names, [this, key](const std::string& text) { given_[key] = text; },
            fmt::format("{} [{}; {}]", info.help, choices_of(info), preset_values(info)))
        ->group("Settings")
        ->type_name(number                                 ? "NUMBER"
                    : info.kind == SettingInfo::Kind::Body ? "BODY"
                                                           : "WORD")
        ->check([key](const std::string& text) {
          Settings scratch;
          const Status usable = set_setting(scratch, key, text);
          // CLI11 puts the option's name, which is the error's place, in front.
          return usable.ok() ? std::string() : usable.error().message;
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
  for (BodyChoice* choice : {&settings->active_body, &settings->passive_body})
    if (const Status measured = measure_file(*choice); !measured) return measured.error();
  return settings;
}

}  // namespace abrazo::app
