#include "tests/fuzz/view_json_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "app/workbench/project/remembered_view.hpp"
#include "app/workbench/shell/dock_state.hpp"
#include "app/workbench/shell/window_layout.hpp"
#include "core/session/frames/markers.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "widgets/scene/values/scene_memory.hpp"

namespace abrazo::fuzz {

namespace {

void expect_layout(std::string_view text) {
  const auto layout =
      app::parse_layout(QByteArray(text.data(), static_cast<int>(text.size())), "layout.json");
  if (!accepted(layout)) return;
  const int timeline = layout->timeline_height.value_or(0);
  expect(timeline >= 0 && timeline < 100'000, "a timeline of no height");
  (void)app::is_dock_state(layout->docks, app::layout_version);
  // Once through: JSON may name half a character, which is written as another.
  const auto written = app::parse_layout(app::text_of(*layout), "layout.json");
  expect(written.ok() && written->docks == layout->docks && written->sides == layout->sides,
         "a layout comes back as another");
  expect(*app::parse_layout(app::text_of(*written), "layout.json") == *written,
         "a layout does not come to rest");
}

void expect_markers(const std::string& text) {
  const Markers markers = parse_markers(text);
  std::set<int> ids;
  double before_s = -std::numeric_limits<double>::infinity();
  for (const Marker& marker : markers.all()) {
    expect(std::isfinite(marker.time_s) && marker.time_s >= before_s,
           "markers are not in the order of their times");
    expect(marker.id > 0 && marker.id < markers.next_id() && ids.insert(marker.id).second,
           "two markers of one id");
    before_s = marker.time_s;
  }
  // Ids that no hand has reached are given anew.
  constexpr int many = 1'000'000'000;
  const Markers written = parse_markers(markers_json(markers));
  expect(std::ranges::equal(written.all(), markers.all(),
                            [](const Marker& a, const Marker& b) {
                              return (a.id == b.id || a.id >= many) && a.time_s == b.time_s;
                            }),
         "markers come back as others");
  expect(markers.next_id() > many || parse_markers(markers_json(written)) == written,
         "markers do not come to rest");
}

void expect_camera(const std::string& text) {
  const auto turn = app::camera_turn_of(text);
  if (!turn) return;
  expect(std::abs(turn->azimuth_rad) < 3.2 && std::abs(turn->elevation_rad) < 1.6,
         "a camera that looks from nowhere");
  const auto again = app::camera_turn_of(app::text_of(*turn));
  expect(again && again->azimuth_rad == turn->azimuth_rad && again->elevation_rad == turn->elevation_rad,
         "a camera comes back as another");
}

void expect_scene(const std::string& text) {
  const widgets::SceneMemory memory = widgets::scene_memory_of(QString::fromStdString(text));
  const widgets::SceneOptions& options = memory.options;
  expect(options.shortest_m >= 0 && options.shortest_m <= 3 && options.longest_m >= 0, "edges of no length");
  expect(options.apart >= 0 && options.apart <= 2 && options.trail_s > 0 && options.trail_s < 1000,
         "cells or trails out of range");
  const widgets::SceneMemory again = widgets::scene_memory_of(widgets::text_of(memory));
  expect(again.visibility == memory.visibility && again.scalar == memory.scalar && again.options == options,
         "a scene comes back as another");
}

}  // namespace

void expect_view(std::string_view text) {
  expect_layout(text);
  expect_markers(std::string(text));
  expect_camera(std::string(text));
  expect_scene(std::string(text));
}

}  // namespace abrazo::fuzz
