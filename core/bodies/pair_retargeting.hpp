#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/bodies/recorded_pair.hpp"
#include "core/mesh/capsules.hpp"
#include "core/synthesis/bodies/pair_fit.hpp"
#include "core/synthesis/bodies/placed_pair.hpp"

namespace abrazo {

/// Bodies of the two characters.
struct PairBodies {
  BodyChange active, passive;
};

/// One frame of the result.
struct RetargetedFrame {
  PairPose pose = PairPose::Zero();  ///< active, passive; world [m]
  PairFit::LetGo let_go = PairFit::LetGo::Nothing;
  double bone_error = 0;         ///< largest, relative
  double foot_drift_m = 0;       ///< largest of standing feet
  double excess_m = 0;           ///< deepest overlap beyond the recording's
  int holds = 0;                 ///< hands that hold one another in the recording
  double hold_change_m = 0;      ///< largest change of the distance of two hands that hold one another
  HandEnds changed_hold{};       ///< those hands
  std::array<bool, 4> stands{};  ///< active left, active right, passive left, passive right

  /// Whether the recorded pose is impossible for these bodies: a hold opens by more than `reachable_m`, or
  /// constraints were relaxed.
  bool is_nearest_only() const;
  /// The reason in a few words; empty if the pose is possible.
  std::string shortfall() const;
  static constexpr double reachable_m = 0.05;
};

struct RetargetedPair {
  RecordedPair recorded;
  PairBodies bodies;
  PairCapsules capsules;
  std::vector<RetargetedFrame> frames;

  Clip active() const;   ///< called "active"
  Clip passive() const;  ///< called "passive"
};

/// Transfers a recorded pair to two other bodies: contacts between them are kept, foot positions scale with
/// the legs, bones are exact. Uses past and future frames: (1) each frame is fitted with feet that follow the
/// bodies; (2) steps are planned from the result, and each frame is fitted to them; (3) the change of (2) is
/// smoothed without lag (Hann, 0.1 s to either side), and each frame is fitted near the smoothed pose.
/// Unchanged bodies give the recording, to the bit. Uses all processor cores; the result does not depend on
/// their number.
/// @throws std::invalid_argument if the clips are empty or of different lengths
/// @return an Error "cancelled" if `progress` cancels
Result<RetargetedPair> retarget_pair(RecordedPair recorded, const PairBodies& bodies,
                                     const Progress& progress = {}, const FitWeights& weights = {});

/// The pair before the mesh between the bodies is fitted: rebuilt on a common path that is scaled by the
/// mean of the leg ratios. Feet follow from the bones, or are placed on their steps.
std::vector<PairPose> rebuilt_on_path(const RecordedPair& recorded, const PairBodies& bodies);
std::vector<PairPose> rebuilt_on_steps(const RecordedPair& recorded, const PairBodies& bodies);

/// Scale of the common path of two bodies: mean of their leg ratios.
double path_scale(const PairBodies& bodies);

/// Radii of both recorded bodies, calibrated on the recording, and of the new bodies.
PairCapsules capsules_of(const RecordedPair& recorded, const PairBodies& bodies);

}  // namespace abrazo
