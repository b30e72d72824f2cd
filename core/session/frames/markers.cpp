#include "core/session/frames/markers.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/limits.hpp"
#include "core/base/json_text.hpp"
#include "core/base/text.hpp"

namespace abrazo {

const Marker* Markers::find(int id) const {
  const auto found =
      std::find_if(markers_.begin(), markers_.end(), [id](const Marker& m) { return m.id == id; });
  return found == markers_.end() ? nullptr : &*found;
}

void Markers::sort() {
  std::stable_sort(markers_.begin(), markers_.end(),
                   [](const Marker& a, const Marker& b) { return a.time_s < b.time_s; });
}

int Markers::add(double time_s, std::string_view name) {
  markers_.push_back({next_id_, time_s, std::string(trimmed(name))});
  sort();
  return next_id_++;
}

void Markers::move(int id, double time_s) {
  for (Marker& marker : markers_)
    if (marker.id == id) marker.time_s = time_s;
  sort();
}

void Markers::rename(int id, std::string_view name) {
  for (Marker& marker : markers_)
    if (marker.id == id) marker.name = trimmed(name);
}

void Markers::remove(int id) {
  std::erase_if(markers_, [id](const Marker& marker) { return marker.id == id; });
}

Markers Markers::restored(std::vector<Marker> markers, int next_id) {
  Markers restored;
  restored.next_id_ = std::max(1, next_id);
  for (const Marker& marker : markers) restored.next_id_ = std::max(restored.next_id_, marker.id + 1);
  std::set<int> taken;
  for (Marker& marker : markers) {
    if (marker.id < 1 || !taken.insert(marker.id).second) marker.id = restored.next_id_++;
    restored.markers_.push_back(std::move(marker));
  }
  restored.sort();
  return restored;
}

const Marker* Markers::before(double time_s, double apart_s) const {
  const Marker* found = nullptr;
  for (const Marker& marker : markers_)
    if (marker.time_s < time_s - apart_s) found = &marker;
  return found;
}

const Marker* Markers::after(double time_s, double apart_s) const {
  for (const Marker& marker : markers_)
    if (marker.time_s > time_s + apart_s) return &marker;
  return nullptr;
}

const Marker* Markers::near(double time_s, double reach_s) const {
  const Marker* nearest = nullptr;
  for (const Marker& marker : markers_) {
    const double distance = std::abs(marker.time_s - time_s);
    if (distance <= reach_s && (!nearest || distance < std::abs(nearest->time_s - time_s))) nearest = &marker;
  }
  return nearest;
}

std::string marker_title(const Marker& marker) {
  return marker.name.empty() ? std::to_string(marker.id) : marker.name;
}

std::string markers_json(const Markers& markers) {
  JsonText json;
  json.begin_array();
  for (const Marker& marker : markers.all())
    json.begin_object()
        .key("id")
        .value(marker.id)
        .key("name")
        .value(marker.name)
        .key("time_s")
        .value(marker.time_s)
        .end_object();
  json.end_array();
  return json.take();
}

Markers parse_markers(std::string_view json) {
  constexpr int most = 1'000'000'000;
  if (json_beyond_bounds(json)) return {};
  std::vector<Marker> markers;
  int last_id = 0;
  const auto list = nlohmann::json::parse(json, nullptr, false);
  if (!list.is_array()) return {};
  for (const auto& each : list) {
    if (!each.is_object()) continue;
    const auto time = each.find("time_s"), name = each.find("name"), id = each.find("id");
    if (time == each.end() || !time->is_number() || !std::isfinite(time->get<double>())) continue;
    const double number = id != each.end() && id->is_number() ? id->get<double>() : 0;
    markers.push_back({static_cast<int>(std::clamp<double>(number, 0, most)), time->get<double>(),
                       name != each.end() && name->is_string() ? name->get<std::string>() : std::string()});
    last_id = std::max(last_id, markers.back().id);
  }
  return Markers::restored(std::move(markers), last_id + 1);
}

}  // namespace abrazo
