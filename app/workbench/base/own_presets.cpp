#include "app/workbench/base/own_presets.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.hpp"
#include "core/base/limits.hpp"
#include "core/base/text.hpp"

namespace abrazo::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t longest_name = 60;

Result<std::vector<OwnPreset>> interpreted(const std::string& text, const std::string& place) {
  const Error unreadable{
      "is not a list of presets, or is damaged; repair it or move it away. It stays unchanged", place};
  if (const char* beyond = json_beyond_bounds(text)) return Error{beyond, place};
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("abrazo_presets")) return unreadable;
  std::vector<OwnPreset> presets;
  try {
    for (const Json& entry : json.at("presets")) {
      const auto name = entry.at("name").get<std::string>();
      auto settings = parse_settings(entry.at("settings").dump(), Settings{}, place + ", preset " + name);
      if (!settings) return settings.error();
      presets.push_back({name, *settings});
    }
  } catch (const nlohmann::json::exception&) {
    return unreadable;
  }
  return presets;
}

Result<std::vector<OwnPreset>> read_presets(const fs::path& file) {
  std::error_code failure;
  if (!fs::exists(file, failure) && !failure) return std::vector<OwnPreset>{};
  const auto text = read_whole_file(file);
  if (!text) return text.error();
  return interpreted(*text, file.string());
}

std::string preset_text(const std::vector<OwnPreset>& presets) {
  Json list = Json::array();
  for (const OwnPreset& preset : presets)
    list.push_back({{"name", preset.name}, {"settings", Json::parse(settings_json(preset.settings))}});
  return Json{{"abrazo_presets", 1}, {"presets", list}}.dump(2) + "\n";
}

std::vector<OwnPreset>::iterator find(std::vector<OwnPreset>& presets, const std::string& name) {
  return std::find_if(presets.begin(), presets.end(), [&](const OwnPreset& p) { return p.name == name; });
}

Status check_name(const std::string& name) {
  if (name.empty()) return Error{"a preset needs a name", "presets"};
  if (name.size() > longest_name)
    return Error{"the name is too long; use at most 60 letters", in_quotes(name)};
  if (std::find(preset_names.begin(), preset_names.end(), name) != preset_names.end())
    return Error{"is a preset of the program; choose another name", in_quotes(name)};
  return Done{};
}

}  // namespace

OwnPresets::OwnPresets(fs::path file) : file_(std::move(file)) {}

Status OwnPresets::read() {
  presets_.clear();
  auto presets = read_presets(file_);
  if (!presets) return presets.error();
  presets_ = std::move(*presets);
  return Done{};
}

Status OwnPresets::write(std::vector<OwnPreset> presets) {
  // Another window may have changed or damaged it: only a readable file is replaced.
  if (const auto there = read_presets(file_); !there) return there.error();
  if (const Status written = write_whole_file(file_, preset_text(presets)); !written) return written;
  presets_ = std::move(presets);
  return Done{};
}

Status OwnPresets::save(const std::string& wanted, const Settings& settings) {
  const std::string name(trimmed(wanted));
  if (const Status usable = check_name(name); !usable) return usable;
  std::vector<OwnPreset> presets = presets_;
  if (const auto found = find(presets, name); found != presets.end())
    found->settings = settings;
  else
    presets.push_back({name, settings});
  return write(std::move(presets));
}

Result<int> OwnPresets::adopt(const std::string& content, const std::string& place) {
  auto offered = interpreted(content, place);
  if (!offered) return offered.error();
  std::vector<OwnPreset> presets = presets_;
  for (OwnPreset& preset : *offered)
    if (check_name(preset.name) && find(presets, preset.name) == presets.end())
      presets.push_back(std::move(preset));
  const int added = static_cast<int>(presets.size() - presets_.size());
  if (added == 0) return 0;
  if (const Status written = write(std::move(presets)); !written) return written.error();
  return added;
}

Status OwnPresets::rename(const std::string& from, const std::string& wanted) {
  const std::string to(trimmed(wanted));
  if (const Status usable = check_name(to); !usable) return usable;
  std::vector<OwnPreset> presets = presets_;
  const auto found = find(presets, from);
  if (found == presets.end()) return Error{"there is no such preset", in_quotes(from)};
  if (from != to && find(presets, to) != presets.end())
    return Error{"there is a preset of this name already; choose another one", in_quotes(to)};
  found->name = to;
  return write(std::move(presets));
}

Status OwnPresets::remove(const std::string& name) {
  std::vector<OwnPreset> presets = presets_;
  std::erase_if(presets, [&](const OwnPreset& p) { return p.name == name; });
  return write(std::move(presets));
}

std::string readable_settings(const Settings& settings) {
  return Json::parse(settings_json(settings)).dump(2) + "\n";
}

Result<Settings> read_settings_file(const fs::path& file, const Settings& start) {
  const auto text = read_whole_file(file);
  if (!text) return text.error();
  return parse_settings(*text, start, file.string());
}

}  // namespace abrazo::app
