#include "core/opening/import_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/atomic_file.hpp"
#include "core/base/checksum.hpp"
#include "core/base/limits.hpp"
#include "core/base/json_text.hpp"
#include "core/base/text.hpp"

namespace abrazo {
namespace {

namespace fs = std::filesystem;
using RuleJson = nlohmann::json;

/// An entry of the JSON, and what it is called for a person.
struct TextEntry {
  const char* key;
  const char* words;
  std::string MotionReading::*value;
};
struct NumberEntry {
  const char* key;
  const char* words;
  std::optional<double> MotionReading::*value;
};

constexpr std::array text_entries = {
    TextEntry{"up", "up", &MotionReading::up},
    TextEntry{"joint_map", "joints by", &MotionReading::joint_map},
    TextEntry{"joints", "order of joints", &MotionReading::joints},
    TextEntry{"performer", "performer", &MotionReading::performer},
    TextEntry{"animation", "animation", &MotionReading::animation},
    TextEntry{"body_model", "body", &MotionReading::body_model},
};
constexpr std::array number_entries = {
    NumberEntry{"metres_per_unit", "metres per unit", &MotionReading::metres_per_unit},
    NumberEntry{"fps", "frames a second", &MotionReading::fps},
    NumberEntry{"floor_m", "floor at [m]", &MotionReading::floor_m},
};

void write_reading(JsonText& json, const MotionReading& reading) {
  json.begin_object();
  for (const TextEntry& entry : text_entries)
    if (!(reading.*entry.value).empty()) json.key(entry.key).value(reading.*entry.value);
  for (const NumberEntry& entry : number_entries)
    if (reading.*entry.value) json.key(entry.key).value(*(reading.*entry.value));
  json.end_object();
}

Status take_entry(const std::string& key, const RuleJson& value, const std::string& where,
                  MotionReading& reading) {
  for (const TextEntry& entry : text_entries)
    if (key == entry.key) {
      if (!value.is_string()) return Error{"expected a text for '" + key + "'", where};
      reading.*entry.value = value.get<std::string>();
      return Done{};
    }
  for (const NumberEntry& entry : number_entries)
    if (key == entry.key) {
      if (!value.is_number()) return Error{"expected a number for '" + key + "'", where};
      reading.*entry.value = value.get<double>();
      return Done{};
    }
  std::string known;
  for (const TextEntry& entry : text_entries) known += std::string(entry.key) + ", ";
  for (const NumberEntry& entry : number_entries) known += std::string(entry.key) + ", ";
  return Error{
      "there is no " + in_quotes(key) + " of reading a motion; expected " + known.substr(0, known.size() - 2),
      where};
}

Result<MotionReading> reading_in(const RuleJson& json, const std::string& where) {
  if (!json.is_object()) return Error{R"(expected {"up": "z", "metres_per_unit": 0.01, ...})", where};
  MotionReading reading;
  for (const auto& [key, value] : json.items())
    if (const Status taken = take_entry(key, value, where, reading); !taken) return taken.error();
  return reading;
}

Result<RuleJson> json_in(std::string_view text, const std::string& where) {
  if (const char* beyond = json_beyond_bounds(text)) return Error{beyond, where};
  RuleJson json = RuleJson::parse(text, nullptr, false);
  if (json.is_discarded()) return Error{"is no JSON; remove it, and say again how the motion is read", where};
  return json;
}

std::string rule_json(const ImportRule& rule) {
  JsonText json;
  json.begin_object();
  json.key("layout").value(rule.layout).key("folder").value(rule.folder);
  json.key("name_pattern").value(rule.name_pattern);
  json.key("how");
  write_reading(json, rule.how);
  json.end_object();
  return json.take() + "\n";
}

Result<ImportRule> parse_rule(const std::string& text, const std::string& where) {
  const auto json = json_in(text, where);
  if (!json) return json.error();
  for (const char* key : {"layout", "folder", "name_pattern"})
    if (!json->is_object() || !json->contains(key) || !(*json)[key].is_string())
      return Error{std::string("expected a text '") + key + "'; remove the rule, and say it again", where};
  auto how = reading_in(json->value("how", RuleJson()), where);
  if (!how) return how.error();
  return ImportRule{std::move(*how), (*json)["layout"], (*json)["folder"], (*json)["name_pattern"], where};
}

std::string folder_of(const std::string& file) {
  std::error_code ignored;
  return fs::absolute(file, ignored).lexically_normal().parent_path().string();
}

/// The same for the same layout and folder, so that a new rule replaces the previous one.
std::string file_of_rule(const ImportRule& rule) {
  Checksum sum;
  sum.add(rule.layout), sum.add("\n"), sum.add(rule.folder);
  return fmt::format("{:016x}.json", static_cast<std::uint64_t>(sum.value()));
}

}  // namespace

std::string reading_json(const MotionReading& reading) {
  JsonText json;
  write_reading(json, reading);
  return json.take();
}

Result<MotionReading> parse_reading(std::string_view text, std::string_view where) {
  const auto json = json_in(text, std::string(where));
  if (!json) return json.error();
  return reading_in(*json, std::string(where));
}

std::string reading_words(const MotionReading& reading) {
  std::string words;
  const auto add = [&words](const char* name, const std::string& value) {
    words += (words.empty() ? "" : ", ") + std::string(name) + " " + value;
  };
  for (const TextEntry& entry : text_entries)
    if (const std::string& value = reading.*entry.value; !value.empty())
      add(entry.words, fs::path(value).filename().string());
  for (const NumberEntry& entry : number_entries)
    if (reading.*entry.value) add(entry.words, exact_text(*(reading.*entry.value)));
  return words;
}

std::string layout_of(const std::vector<NamedMotion>& motions) {
  if (motions.empty()) return {};
  std::set<std::string> points;
  for (const NamedMotion& motion : motions) points.insert(motion.points.begin(), motion.points.end());
  Checksum sum;
  for (const std::string& point : points) sum.add(point), sum.add("\n");
  const NamedMotion& first = motions.front();
  sum.add(first.metres_per_unit ? exact_text(*first.metres_per_unit) : "no unit");
  sum.add(first.up_axis ? axis_label(*first.up_axis) : "no axis");
  return fmt::format("{:016x}", static_cast<std::uint64_t>(sum.value()));
}

std::string name_pattern(const std::string& file) {
  std::string pattern;
  for (const char c : fs::path(file).filename().string()) {
    if (std::isdigit(static_cast<unsigned char>(c)) == 0)
      pattern += c;
    else if (pattern.empty() || pattern.back() != '#')
      pattern += '#';
  }
  return pattern;
}

ImportRule rule_of(const MotionReading& how, const std::string& layout) {
  ImportRule rule{how, layout, folder_of(how.file), name_pattern(how.file), {}};
  rule.how.file.clear();
  rule.how.skeleton.clear();
  return rule;
}

StoredRules import_rules(const std::string& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  StoredRules stored;
  for (const fs::path& file : files) {
    const auto text = read_whole_file(file);
    auto rule = text ? parse_rule(*text, file.string()) : Result<ImportRule>(text.error());
    if (rule)
      stored.rules.push_back(std::move(*rule));
    else
      stored.damaged.push_back(rule.error());
  }
  std::ranges::sort(stored.rules, {},
                    [](const ImportRule& rule) { return std::pair(rule.name_pattern, rule.path); });
  return stored;
}

const ImportRule* rule_for(const std::vector<ImportRule>& rules, const std::string& file,
                           const std::string& layout) {
  if (layout.empty()) return nullptr;
  const ImportRule* alike = nullptr;
  for (const ImportRule& rule : rules) {
    if (rule.layout != layout) continue;
    if (rule.folder == folder_of(file)) return &rule;
    if (rule.name_pattern == name_pattern(file)) alike = &rule;
  }
  return alike;
}

Result<std::string> remember_import(const ImportRule& rule, const std::string& folder) {
  std::error_code trouble;
  fs::create_directories(folder, trouble);
  if (trouble)
    return Error{"cannot be made (" + trouble.message() + "); how the motion is read is not remembered",
                 folder};
  const fs::path file = fs::path(folder) / file_of_rule(rule);
  if (const Status written = write_whole_file(file, rule_json(rule)); !written) return written.error();
  return file.string();
}

Status forget_import(const std::string& path) {
  std::error_code trouble;
  fs::remove(path, trouble);
  if (trouble) return Error{"cannot be removed (" + trouble.message() + ")", path};
  return Done{};
}

}  // namespace abrazo
