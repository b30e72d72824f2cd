#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/limits.hpp"
#include "core/base/json_text.hpp"
#include "core/motion/joints/marker_model.hpp"
#include "core/motion/joints/marker_places.hpp"

namespace abrazo {

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr std::array<const char*, marker_place_count> place_names = {
    "neck",        "back",        "clavicle",  "sternum",     "sacrum",      "head top",     "head front",
    "head side",   "front head",  "back head", "ear",         "collar bone", "front pelvis", "back pelvis",
    "shoulder",    "upper arm",   "elbow",     "inner elbow", "thumb wrist", "little wrist", "hand",
    "thumb hand",  "little hand", "thigh",     "knee",        "inner knee",  "shin",         "ankle",
    "inner ankle", "heel",        "toe",       "inner toe",   "outer toe",   "toe tip"};

Result<std::vector<std::string>> names_in(const OrderedJson& entry, const std::string& where) {
  std::vector<std::string> names;
  const auto take = [&](const OrderedJson& name) {
    if (!name.is_string() || name.get<std::string>().empty()) return false;
    names.push_back(name.get<std::string>());
    return true;
  };
  const bool usable =
      entry.is_array() ? !entry.empty() && std::all_of(entry.begin(), entry.end(), take) : take(entry);
  if (!usable) return Error{"expected the name of a marker, or a list of names", where};
  return names;
}

}  // namespace

std::string name_of_place(MarkerPlace place, std::size_t side) {
  const auto index = static_cast<std::size_t>(place);
  const std::string name = place_names[index];
  return index < first_sided_place ? name : (side == 0 ? "left " : "right ") + name;
}

std::optional<std::pair<MarkerPlace, std::size_t>> marker_spot(std::string_view name) {
  for (std::size_t place = 0; place < marker_place_count; ++place)
    for (std::size_t side = 0; side < (place < first_sided_place ? 1U : 2U); ++side)
      if (name == name_of_place(static_cast<MarkerPlace>(place), side))
        return std::pair(static_cast<MarkerPlace>(place), side);
  return std::nullopt;
}

std::string all_marker_places() {
  std::string names;
  for (std::size_t place = 0; place < marker_place_count; ++place)
    names += (place > 0 ? ", " : "") + name_of_place(static_cast<MarkerPlace>(place), 0);
  return names;
}

Result<MarkerModel> parse_marker_model(std::string_view text, std::string_view where) {
  const std::string file(where);
  if (const char* beyond = json_beyond_bounds(text)) return Error{beyond, file};
  const OrderedJson json = OrderedJson::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("markers") || !json["markers"].is_object())
    return Error{R"(expected {"name": "...", "markers": {"neck": "C7", "left shoulder": "LSHO", ...}})",
                 file};
  MarkerModel model;
  model.name = json.contains("name") && json["name"].is_string() ? json["name"].get<std::string>() : file;
  for (const auto& [name, entry] : json["markers"].items()) {
    const auto spot = marker_spot(name);
    if (!spot)
      return Error{"there is no place '" + name + "' for a marker; expected one of " + all_marker_places(),
                   file};
    auto names = names_in(entry, file + ": markers." + name);
    if (!names) return names.error();
    model.names[static_cast<std::size_t>(spot->first)][spot->second] = std::move(*names);
  }
  return model;
}

bool is_marker_model(std::string_view text) {
  if (json_beyond_bounds(text)) return false;
  const OrderedJson json = OrderedJson::parse(text, nullptr, false);
  return json.is_object() && json.contains("markers") && !json.contains("joints");
}

std::string marker_model_json(const MarkerModel& model) {
  JsonText json;
  json.begin_object();
  json.key("name").value(model.name);
  json.key("markers").begin_object();
  for (std::size_t place = 0; place < marker_place_count; ++place)
    for (const std::size_t side : {0U, 1U}) {
      const auto& names = model.names[place][side];
      if (names.empty()) continue;
      json.key(name_of_place(static_cast<MarkerPlace>(place), side)).begin_array();
      for (const std::string& name : names) json.value(name);
      json.end_array();
    }
  json.end_object();
  json.end_object();
  return json.text() + "\n";
}

}  // namespace abrazo
