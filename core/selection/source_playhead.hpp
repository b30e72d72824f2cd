#pragma once

#include <optional>

#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// Position of the partner's motion in the recording: a continuous time in a take, and its rate. Time is
/// counted in pairs of the library, so that steps may be faster or slower than recorded frames.
struct SourcePlayhead {
  int pair = -1;        ///< the recorded pair at or before the source time; -1 = no source
  double fraction = 0;  ///< of the way to the next pair, in [0, 1); 0 if there is no next one
  double rate = 1;      ///< source seconds per second

  bool operator==(const SourcePlayhead&) const = default;
};

/// Pairs of the take's library per second.
double pair_rate(const MotionLibrary& library, int pair);

/// The playhead moved by `seconds` of source time (negative: earlier); stops at the end of the recording or
/// at a gap.
SourcePlayhead moved(const MotionLibrary& library, const SourcePlayhead& playhead, double source_s);

/// Recorded time after the playhead, at most `most_s` [s].
double recorded_ahead(const MotionLibrary& library, const SourcePlayhead& playhead, double most_s);

/// The pair whose frame is nearest to the source time.
int nearest_pair(const MotionLibrary& library, const SourcePlayhead& playhead);

/// Source seconds from the playhead to a pair of the same stretch; none if it is in another stretch.
std::optional<double> seconds_to(const MotionLibrary& library, const SourcePlayhead& playhead, int pair);

/// A recorded pair between two frames: positions and roots are interpolated linearly.
struct RecordedMoment {
  /// Both bodies relative to the active root and heading; heights are above the floor [m].
  PairPose pair = PairPose::Zero();
  /// The passive body relative to its own root and heading [m].
  Pose partner_own = Pose::Zero();
  RootFrame partner;          ///< the passive root in `pair`; its height is above the floor
  RootFrame partner_in_take;  ///< the same in the take's world
};

RecordedMoment recorded_moment(const MotionLibrary& library, const SourcePlayhead& playhead);

/// `angle` wrapped to half a turn about 0 [rad].
double within_half_turn(double angle);

}  // namespace abrazo
