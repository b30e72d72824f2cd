#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/synthesis/preset_choice.hpp"

namespace abrazo::app {

/// A person's own presets in one readable JSON file, which is replaced whole or not at all. A file that
/// cannot be read is never written to.
class OwnPresets {
 public:
  /// @param file  need not be there
  explicit OwnPresets(std::filesystem::path file);

  /// An Error names the file and what is wrong with it; there are no presets then.
  Status read();
  const std::vector<OwnPreset>& all() const { return presets_; }

  /// Under a new name, or in place of those of that name.
  Status save(const std::string& name, const Settings& settings);
  /// Those of a file's content whose names are free; none is replaced. @return how many
  Result<int> adopt(const std::string& content, const std::string& place);
  Status rename(const std::string& from, const std::string& to);
  Status remove(const std::string& name);

 private:
  Status write(std::vector<OwnPreset> presets);

  std::filesystem::path file_;
  std::vector<OwnPreset> presets_;
};

/// Every setting, one to a line, as `--settings` takes it.
std::string readable_settings(const Settings& settings);

/// Those of a file that was exported, or written by hand with only some keys; the rest is as in `start`.
Result<Settings> read_settings_file(const std::filesystem::path& file, const Settings& start);

}  // namespace abrazo::app
