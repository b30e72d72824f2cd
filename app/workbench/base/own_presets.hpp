#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/synthesis/settings/preset_choice.hpp"

namespace abrazo::app {

/// The user's own presets in one readable JSON file, which is replaced completely or not at all. An
/// unreadable file is never overwritten.
class OwnPresets {
 public:
  /// @param file may be missing
  explicit OwnPresets(std::filesystem::path file);

  /// Reads the file. The Error names the file and the problem; there are no presets then.
  Status read();
  const std::vector<OwnPreset>& all() const { return presets_; }

  /// Saves under a name, replacing a preset of that name.
  Status save(const std::string& name, const Settings& settings);
  /// Imports presets with free names; existing ones are not replaced. @return their number
  Result<int> adopt(const std::string& content, const std::string& place);
  Status rename(const std::string& from, const std::string& to);
  Status remove(const std::string& name);

 private:
  Status write(std::vector<OwnPreset> presets);

  std::filesystem::path file_;
  std::vector<OwnPreset> presets_;
};

/// Every setting, one to a line, in the format of `--settings`.
std::string readable_settings(const Settings& settings);

/// Settings of a file that was exported, or written by hand with some keys; others are as in `start`.
Result<Settings> read_settings_file(const std::filesystem::path& file, const Settings& start);

}  // namespace abrazo::app
