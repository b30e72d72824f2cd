#include "core/synthesis/step/look_ahead.hpp"

#include <algorithm>
#include <cmath>

namespace abrazo {

namespace {

/// Long enough that the line does not jump away from the body, short enough that most of it is as recorded.
constexpr double edit_fades_s = 0.4;

/// One body of a pair where it was recorded.
Pose recorded_body(const MotionLibrary& library, int pair, bool active) {
  const PairPose& pose = library.pose(pair);
  return to_world(active ? Pose(pose.topRows<joint_count>()) : Pose(pose.bottomRows<joint_count>()),
                  library.root(pair));
}

RootFrame on_the_floor(RootFrame root) {
  root.position.y() = 0;
  return root;
}

}  // namespace

int partner_row(const FrameResult& frame) {
  const double active_sq = (frame.active() - frame.query_world).squaredNorm();
  const double passive_sq = (frame.passive() - frame.query_world).squaredNorm();
  return active_sq <= passive_sq ? joint_count : 0;
}

std::vector<Pose> look_ahead(const FrameResult& frame, const MotionLibrary& library, UserRole role,
                             double seconds, double step_s) {
  if (frame.selected < 0 || frame.status == StepStatus::Failed || step_s <= 0) return {};
  const int pair = frame.candidates[static_cast<std::size_t>(frame.selected)].pair;
  if (pair < 0 || pair >= library.pair_count()) return {};
  const bool user_is_active = role == UserRole::Active;
  const RootFrame from =
      on_the_floor(user_is_active ? library.root(pair) : root_frame(recorded_body(library, pair, false)));
  const RootFrame to = on_the_floor(frame.query_root);
  const auto partner_at = [&](int later) -> Pose {
    return to_world(to_normalized(recorded_body(library, later, !user_is_active), from), to);
  };
  std::vector<Pose> ahead = {frame.result.middleRows<joint_count>(partner_row(frame))};
  const Pose edited_by = ahead.front() - partner_at(pair);
  const LibraryTake& take = library.take_of(pair);
  const double pairs_per_s = take.fps / std::max(1, take.frame_stride);
  const int steps = static_cast<int>(std::lround(seconds / step_s));
  for (int step = 1; step <= steps; ++step) {
    const double time_s = step * step_s;
    const int later = library.later_pair(pair, static_cast<int>(std::lround(time_s * pairs_per_s)));
    if (later < 0) break;
    ahead.push_back(partner_at(later) + std::max(0.0, 1 - time_s / edit_fades_s) * edited_by);
  }
  return ahead;
}

}  // namespace abrazo
