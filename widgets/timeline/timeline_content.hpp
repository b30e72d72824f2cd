#pragma once

#include <QPointF>
#include <QRectF>
#include <QString>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/session/frames/markers.hpp"
#include "core/session/frames/playback.hpp"
#include "core/session/frames/settings_track.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/timeline/timeline_lanes.hpp"
#include "widgets/timeline/timeline_tiers.hpp"
#include "widgets/timeline/timeline_tracks.hpp"
#include "widgets/timeline/timeline_viewport.hpp"

namespace abrazo::widgets {

/// A stretch of the session that has a name.
struct TimelineTake {
  std::int64_t id = 0;
  double from_s = 0, to_s = 0;
  std::string name;
  bool is_running = false;  ///< lasts until the live end

  bool operator==(const TimelineTake&) const = default;
};

/// All that a picture of the timeline is made from.
struct TimelineContent {
  Palette palette;
  std::shared_ptr<const MotionLibrary> library;
  TimelineViewport viewport;
  TimelineLanes lanes;
  TimelineTracks tracks;
  SettingsTrack settings;
  std::vector<SettingsChange> settings_marks;  ///< of `settings`, near ones as one
  std::vector<TimelineTake> takes;             ///< in the order they were recorded
  double memory_first_s = 0;                   ///< frames before this are on disk
  Markers markers;
  int selected_marker = 0;
  TimelineTiers tiers;
  Playback playback;
  bool focused = false;

  const TimelineAxis& axis() const { return viewport.axis(); }
};

/// The facts at a place, as rich text; empty where there are none.
QString facts_at(const TimelineContent& content, const QPointF& place);

/// The take at a time, of several the one that was recorded last; null where there is none.
const TimelineTake* take_at(const TimelineContent& content, double time_s);

/// Who leads in a frame that the user's role and the recording tell about.
/// @param pair  the selected one, of this library; -1 = none
Leader leader_of(const FrameSnapshot& frame, int pair, const MotionLibrary* library);

}  // namespace abrazo::widgets
