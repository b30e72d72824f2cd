#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/synthesis/settings.hpp"

namespace abrazo {

/// Settings that a person keeps under a name.
struct OwnPreset {
  std::string name;
  Settings settings;

  bool operator==(const OwnPreset&) const = default;
};

/// Which preset the settings came from: where ticks are and what a star compares with.
struct PresetChoice {
  std::string name = std::string(preset_names.front());
  bool own = false;
  Settings settings = *preset(preset_names.front());

  bool operator==(const PresetChoice&) const = default;
};

/// The preset that these settings are, the one chosen before first; that one still when they are none's.
inline PresetChoice choice_for(const Settings& settings, const PresetChoice& before,
                               const std::vector<OwnPreset>& own) {
  if (before.settings == settings) return before;
  for (const std::string_view name : preset_names)
    if (*preset(name) == settings) return {std::string(name), false, settings};
  const auto found =
      std::find_if(own.begin(), own.end(), [&](const OwnPreset& p) { return p.settings == settings; });
  return found == own.end() ? before : PresetChoice{found->name, true, settings};
}

}  // namespace abrazo
