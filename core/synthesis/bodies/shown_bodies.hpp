#pragma once

#include <array>
#include <span>
#include <string_view>

#include "core/base/positions.hpp"
#include "core/mesh/capsules.hpp"
#include "core/synthesis/bodies/gliding_body.hpp"
#include "core/synthesis/bodies/pair_fit.hpp"
#include "core/synthesis/frames/frame_result.hpp"

namespace abrazo {

/// What the next frame on other bodies needs of the last, as a plain value. World [m].
struct ShownMemory {
  std::array<GlidingBody, 2> bodies;       ///< of the user's character, of the partner
  bool is_fitted = false;                  ///< the last frame was shown on other bodies than the library's
  double leaves_s = 0;                     ///< since the characters have the library's bodies again
  PairPose change = PairPose::Zero();      ///< fitted pair minus rebuilt pair
  PairPose difference = PairPose::Zero();  ///< shown pair minus solved pair
  Vec3 shift = Vec3::Zero();               ///< of the partner, so that near joints keep their relation
  std::array<Vec3, 2> feet = {Vec3::Zero(), Vec3::Zero()};          ///< the solved partner's toe bases
  std::array<Vec3, 2> foot_offsets = {Vec3::Zero(), Vec3::Zero()};  ///< from their scaled path; y is 0
};

/// One solved frame that is shown on other bodies. World [m].
struct ShownTask {
  std::span<const MeshEdge> edges;
  const PairPose& solved;                 ///< user's character and partner on the library's bodies
  const Pose& user;                       ///< the pose of the user's character on its body
  double path = 1;                        ///< scale of the floor from the solved pair to `user`
  std::array<const Body*, 2> recorded{};  ///< bodies of the solved pair
  std::array<const CapsuleRadii*, 2> radii{};
  std::span<const HandHold> holds;  ///< of the solved pair
  double elapsed_s = 0;             ///< since the last frame; 0 at the start
  bool continues = false;           ///< a pair was shown before
  double pose_weight = 10;          ///< w_C: holds the user's character to `user`
};

/// Shows a pair that was solved on the library's bodies on two other bodies: the user's character gets the
/// given pose, the partner is rebuilt on its body and both are fitted to the spatial relation of the solved
/// pair (@see PairFit). Causal: uses the last frame only. Does not allocate.
class ShownBodies {
 public:
  ShownBodies();

  /// The bodies are `memory.bodies`, already advanced.
  const PairFit::Outcome& fit(const ShownTask& task, ShownMemory& memory);

  /// Why the last result is only the nearest pose; empty if it is not.
  std::string_view shortfall() const { return shortfall_; }
  CapsuleContacts& contacts() { return fit_.contacts(); }

 private:
  void rebuild(const ShownTask& task, ShownMemory& memory);
  Vec3 wanted_shift(const ShownTask& task, const Pose& partner) const;
  void weigh_feet(const ShownMemory& memory);
  void judge(const ShownTask& task);

  PairFit fit_;
  FitTask task_;
  PairPose smoothed_ = PairPose::Zero();
  PairFit::Outcome outcome_;
  std::string_view shortfall_;
};

/// The pair while the characters return to the library's bodies: what is left of the difference fades.
/// @param[in,out] memory  is_fitted is false at the end
PairPose returning_to(const PairPose& solved, double elapsed_s, ShownMemory& memory);

}  // namespace abrazo
