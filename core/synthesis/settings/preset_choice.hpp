#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/synthesis/settings/settings.hpp"

namespace abrazo {

/// Settings that a person saved under a name.
struct OwnPreset {
  std::string name;
  Settings settings;

  bool operator==(const OwnPreset&) const = default;
};

/// The preset that the settings came from: the base of the default ticks and of the change marker.
struct PresetChoice {
  std::string name = std::string(preset_names.front());
  bool own = false;
  Settings settings = *preset(preset_names.front());

  bool operator==(const PresetChoice&) const = default;
};

/// The preset that these settings equal, preferring the one chosen before; that one also if they equal none.
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
