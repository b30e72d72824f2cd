#include "core/evaluation/sweep/sweep_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.hpp"
#include "core/base/limits.hpp"
#include "core/base/version.hpp"
#include "core/evaluation/report/report_json.hpp"

namespace abrazo {

namespace fs = std::filesystem;

namespace {

void write_axis(JsonText& json, std::string_view name, const SweepAxis& axis) {
  json.key(name).begin_object();
  json.key("setting").value(axis.key);
  json.key("values").begin_array();
  for (const std::string& value : axis.values) json.value(value);
  json.end_array().end_object();
}

SweepAxis read_axis(const nlohmann::json& json) {
  return {json.at("setting").get<std::string>(), json.at("values").get<std::vector<std::string>>()};
}

std::string listed(const std::vector<std::string>& values) {
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "" : ", ") + value;
  return text;
}

std::string axis_difference(char name, const SweepAxis& expected, const SweepAxis& found) {
  if (expected == found) return {};
  if (expected.key != found.key) return fmt::format("{} is {} instead of {}", name, found.key, expected.key);
  return fmt::format("{} has the values {} instead of {}", found.key, listed(found.values),
                     listed(expected.values));
}

Result<SweepShardFile> interpreted(const nlohmann::json& json, const fs::path& path) {
  SweepShardFile file;
  file.name = path.filename().string();
  file.sweep.data = json.at("data").get<std::string>();
  file.sweep.metric = json.at("metric").get<std::string>();
  file.sweep.x = read_axis(json.at("x"));
  file.sweep.y = read_axis(json.at("y"));
  file.shard = {json.at("shard").get<int>(), json.at("of").get<int>()};
  auto settings = parse_settings(json.at("settings").dump(), Settings{}, path.string());
  if (!settings) return settings.error();
  file.sweep.settings = *settings;
  for (const nlohmann::json& point : json.at("points"))
    file.points.push_back(point.at("figures").get<Figures>());
  if (const Status usable = check_sweep(file.sweep); !usable)
    return Error{usable.error().text() + "; remove the file", path.string()};
  if (file.shard.count < 1 || file.shard.index < 1 || file.shard.index > file.shard.count ||
      file.points.size() != points_of(file.sweep, file.shard).size())
    return Error{"does not hold the points of its shard; remove the file and evaluate it again",
                 path.string()};
  return file;
}

}  // namespace

void write_sweep_head(JsonText& json, const Sweep& sweep) {
  json.key("abrazo_sweep").value(1);
  json.key("version").value(version());
  json.key("data").value(sweep.data);
  json.key("metric").value(sweep.metric);
  write_axis(json, "x", sweep.x);
  write_axis(json, "y", sweep.y);
}

void write_sweep_point(JsonText& json, const Sweep& sweep, int point, const Figures& figures) {
  const auto [x, y] = grid_place(sweep, point);
  json.begin_object().key("x").value(x).key("y").value(y).key("value");
  const auto value = figures.find(sweep.metric);
  value == figures.end() ? json.null() : json.value(value->second);
  json.key("figures").begin_object();
  for (const auto& [name, figure] : figures) json.key(name).value(figure);
  json.end_object().end_object();
}

std::string shard_json(const Sweep& sweep, const SweepShard& shard, const std::vector<Figures>& points) {
  JsonText json;
  json.begin_object();
  write_sweep_head(json, sweep);
  json.key("shard").value(shard.index);
  json.key("of").value(shard.count);
  json.key("points").begin_array();
  const std::vector<int> own = points_of(sweep, shard);
  for (std::size_t i = 0; i < own.size(); ++i) write_sweep_point(json, sweep, own[i], points[i]);
  json.end_array();
  return finished_with_settings(json, sweep.settings) + "\n";
}

Result<SweepShardFile> read_shard_file(const fs::path& path) {
  const auto text = read_whole_file(path);
  if (!text) return text.error();
  if (const char* beyond = json_beyond_bounds(*text)) return Error{beyond, path.string()};
  const nlohmann::json json = nlohmann::json::parse(*text, nullptr, false);
  if (!json.is_object() || !json.contains("abrazo_sweep"))
    return Error{"is no shard of a sweep, or is damaged; remove or rename it", path.string()};
  try {
    return interpreted(json, path);
  } catch (const nlohmann::json::exception& fault) {
    return Error{fmt::format("is damaged ({}); remove the file and evaluate it again", fault.what()),
                 path.string()};
  }
}

Result<std::vector<SweepShardFile>> read_shard_files(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code failure;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("shard-") && name.ends_with(".json")) paths.push_back(entry.path());
  }
  if (failure) return Error{"cannot be read: " + failure.message(), folder.string()};
  std::sort(paths.begin(), paths.end());
  std::vector<SweepShardFile> files;
  for (const fs::path& path : paths) {
    auto file = read_shard_file(path);
    if (!file) return file.error();
    files.push_back(std::move(*file));
  }
  return files;
}

std::string difference(const Sweep& expected, const Sweep& found) {
  if (expected.data != found.data)
    return fmt::format("it evaluates {} instead of {}", found.data, expected.data);
  for (const std::string& text :
       {axis_difference('x', expected.x, found.x), axis_difference('y', expected.y, found.y)})
    if (!text.empty()) return text;
  for (const SettingInfo& info : all_settings()) {
    if (info.key == expected.x.key || info.key == expected.y.key) continue;
    const std::string wanted = setting_text(expected.settings, info.key),
                      is = setting_text(found.settings, info.key);
    if (wanted != is) return fmt::format("{} is {} instead of {}", info.key, is, wanted);
  }
  return {};
}

}  // namespace abrazo
