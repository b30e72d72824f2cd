#include "core/opening/import_preview.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/opening/import_rules.hpp"

namespace abrazo {
namespace {

/// Diagonal of the ground that the root crosses [m].
double moved_on_the_ground(const std::vector<Pose>& poses) {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e300), high = -low;
  for (const Pose& pose : poses) {
    const Eigen::Vector2d place(pose(joints::Root, 0), pose(joints::Root, 2));
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  return poses.empty() ? 0 : (high - low).norm();
}

/// Of the motions with unknown points, the one with most points.
UnmappedMotion largest_unknown(const std::vector<NamedMotion>& motions) {
  const NamedMotion* largest = nullptr;
  for (const NamedMotion& motion : motions)
    if (!joints_are_known(motion) && (!largest || motion.points.size() > largest->points.size()))
      largest = &motion;
  return largest ? std::make_shared<const NamedMotion>(*largest) : nullptr;
}

}  // namespace

std::vector<std::string> ImportView::questions() const {
  std::vector<std::string> all;
  if (performers.size() > 1 && reading.performer.empty())
    all.push_back(
        fmt::format("the file has {} performers; choose the one who plays the user", performers.size()));
  if (imported.report.animations.size() > 1 && reading.animation.empty())
    all.push_back(
        fmt::format("the file has {} animations and the longest is read; choose another if that "
                    "is wrong",
                    imported.report.animations.size()));
  for (const ImportWarning& warning : imported.report.warnings)
    if (warning.asks) all.push_back(warning.detail);
  return all;
}

std::optional<double> ImportView::floor_to_enter() const {
  constexpr double standing_toes_m = 0.04, noticed_m = 0.03;
  const ImportReport& report = imported.report;
  if (!is_readable() || reading.floor_m || report.floor_shift_m != 0) return std::nullopt;
  const double off_m = report.floor_y_m - standing_toes_m;
  return std::abs(off_m) > noticed_m ? std::optional(std::round(off_m * 1000) / 1000) : std::nullopt;
}

ImportView ImportPreview::look(const MotionReading& reading, const Progress& progress) {
  ImportView view;
  view.reading = reading;
  MotionReading everybody = reading;
  everybody.performer.clear();
  auto clips = points_.performers(everybody, progress);
  view.layout = layout_of(points_.motions());
  if (!clips) {
    view.trouble = clips.error();
    view.unmapped = largest_unknown(points_.motions());
    return view;
  }
  for (const ImportedClip& imported : *clips) view.performers.push_back(imported.clip.name);
  if (!reading.performer.empty()) {
    const auto found = find_performer(*clips, reading.performer);
    if (!found) {
      view.trouble = Error{"has no performer " + reading.performer + "; choose another", reading.file};
      return view;
    }
    view.performer = *found;
  }
  view.imported = std::move((*clips)[view.performer]);
  view.moves_m = moved_on_the_ground(view.imported.clip.poses);
  return view;
}

}  // namespace abrazo
