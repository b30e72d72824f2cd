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

/// A named stretch of the session.
struct TimelineTake {
  std::int64_t id = 0;
  double from_s = 0, to_s = 0;
  std::string name;
  bool is_running = false;  ///< extends to the live end

  bool operator==(const TimelineTake&) const = default;
};

/// The content of a picture of the timeline.
struct TimelineContent {
  Palette palette;
  std::shared_ptr<const MotionLibrary> library;
  TimelineViewport viewport;
  TimelineLanes lanes;
  TimelineTracks tracks;
  SettingsTrack settings;
  std::vector<SettingsChange> settings_marks;  ///< of `settings`, near ones merged
  std::vector<TimelineTake> takes;             ///< in order of recording
  double memory_first_s = 0;                   ///< earlier frames are on disk
  QString lost;                                ///< why the oldest frames are not kept; empty = all are
  Markers markers;
  int selected_marker = 0;
  TimelineTiers tiers;
  Playback playback;
  bool focused = false;

  const TimelineAxis& axis() const { return viewport.axis(); }
};

/// Facts at a position, as rich text; empty if there are none.
QString facts_at(const TimelineContent& content, const QPointF& place);

/// The take at a time, the last recorded of several; null if there is none.
const TimelineTake* take_at(const TimelineContent& content, double time_s);

/// Who leads, from the user's role and the recording.
/// @param pair  the selected one, of this library; -1 = none
Leader leader_of(bool user_is_active, int pair, const MotionLibrary* library);

}  // namespace abrazo::widgets
