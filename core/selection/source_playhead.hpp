#pragma once

#include <optional>

#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// Where in the recording the partner's motion is: a continuous time in a take, and how fast it runs. Time
/// counts in pairs of the library, so that steps may come faster or slower than recorded frames.
struct SourcePlayhead {
  int pair = -1;        ///< the recorded pair at or before the source time; -1 when there is no source
  double fraction = 0;  ///< of the way to the next pair, in [0, 1); 0 where there is no next one
  double rate = 1;      ///< source seconds per second

  bool operator==(const SourcePlayhead&) const = default;
};

/// Pairs of the take's library per second.
double pair_rate(const MotionLibrary& library, int pair);

/// So many source seconds later (or earlier, when negative); stops where the recording ends or has a gap.
SourcePlayhead moved(const MotionLibrary& library, const SourcePlayhead& playhead, double source_s);

/// How long the recording goes on after it, looking ahead no farther than `most_s` [s].
double recorded_ahead(const MotionLibrary& library, const SourcePlayhead& playhead, double most_s);

/// The pair whose frame is nearest to the source time.
int nearest_pair(const MotionLibrary& library, const SourcePlayhead& playhead);

/// Source seconds from the playhead to a pair of the same stretch; nothing when it is of another one.
std::optional<double> seconds_to(const MotionLibrary& library, const SourcePlayhead& playhead, int pair);

/// A recorded pair at a moment between its frames: positions and roots on the line between them.
struct RecordedMoment {
  /// Both bodies relative to the active root and heading; heights are those above the floor [m].
  PairPose pair = PairPose::Zero();
  /// The passive body relative to its own root and heading [m].
  Pose partner_own = Pose::Zero();
  RootFrame partner;          ///< the passive root in `pair`; its height is that above the floor
  RootFrame partner_in_take;  ///< the same in the take's world
};

RecordedMoment recorded_moment(const MotionLibrary& library, const SourcePlayhead& playhead);

/// `angle` plus the turns that bring it within half a turn of 0 [rad].
double within_half_turn(double angle);

}  // namespace abrazo
