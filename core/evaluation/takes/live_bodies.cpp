#include "core/evaluation/takes/live_bodies.hpp"

#include <algorithm>

#include "core/retarget/body_retargeter.hpp"
#include "core/synthesis/bodies/shown_bodies.hpp"

namespace abrazo {

namespace {

constexpr double hold_ramp_s = 0.15;

/// The holds of the recording, which begin and end gradually as live.
class RecordedHolds {
 public:
  void follow(const PairPose& pair, double elapsed_s) {
    holds_.clear();
    for (std::size_t h = 0; h < all_hand_ends.size(); ++h) {
      const HandEnds& hands = all_hand_ends[h];
      const double step = elapsed_s / hold_ramp_s;
      ramps_[h] = std::clamp(ramps_[h] + (hands_hold(pair, hands) ? step : -step), 0.0, 1.0);
      if (ramps_[h] <= 0) continue;
      holds_.push_back({hands.active == joints::left_hand, hands.passive == joints::left_hand, ramps_[h],
                        (pair.row(hands.passive + joint_count) - pair.row(hands.active)).transpose()});
    }
  }
  const std::vector<HandHold>& holds() const { return holds_; }

 private:
  std::array<double, 4> ramps_{};
  std::vector<HandHold> holds_;
};

}  // namespace

LivePair shown_live(const RecordedPair& recorded, const PairBodies& bodies, const PairCapsules& capsules) {
  const BodyRetargeter on_body(bodies.active.from, bodies.active.to);
  const double elapsed_s = 1 / recorded.active.fps;
  ShownBodies shown;
  ShownMemory memory;
  memory.bodies[0].follow(bodies.active.to, false, 0, true);
  memory.bodies[1].follow(bodies.passive.to, false, 0, true);
  RecordedHolds holds;
  LivePair live;
  for (std::size_t frame = 0; frame < recorded.active.poses.size(); ++frame) {
    PairPose pair;
    pair << recorded.active.poses[frame], recorded.passive.poses[frame];
    const InteractionMesh mesh = tetrahedralize(pair);
    const Pose user = on_body.apply(recorded.active.poses[frame]);
    holds.follow(pair, elapsed_s);
    const ShownTask task{.edges = mesh.edges,
                         .solved = pair,
                         .user = user,
                         .path = on_body.path_scale(),
                         .recorded = {&bodies.active.from, &bodies.passive.from},
                         .radii = {&capsules.recorded_active, &capsules.recorded_passive},
                         .holds = holds.holds(),
                         .elapsed_s = frame > 0 ? elapsed_s : 0,
                         .continues = frame > 0};
    live.poses.push_back(shown.fit(task, memory).pose);
    live.nearest_only += !shown.shortfall().empty();
  }
  return live;
}

}  // namespace abrazo
