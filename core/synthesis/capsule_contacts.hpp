#pragma once

#include <array>
#include <vector>

#include "core/base/positions.hpp"
#include "core/mesh/capsules.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/synthesis/constraints.hpp"
#include "core/synthesis/frame_result.hpp"

namespace abrazo {

/// Keeps the capsules of the two bodies apart, as far as the selected pair does itself: recorded contact is
/// contact, so each pair of capsules may overlap by the depth it has in the selected pair. Hands and forearms
/// of two arms that hold one another there are left alone.
class CapsuleContacts {
 public:
  /// Capsules closer than this get a row [m].
  static constexpr double activation_gap_m = 0.05;
  static constexpr int max_rows = 16;

  CapsuleContacts();

  /// Learns what the selected pair allows. Radii are those of the two bodies.
  /// @param clearance_m  how much further apart they are kept than that
  void prepare(const PairPose& selected, const CapsuleRadii& active, const CapsuleRadii& passive,
               double clearance_m = 0);
  /// A capsule whose axis went through another's is pushed back to the side that it has here, in place of
  /// that in the selected pair: what is shown does not jump through a body.
  void keep_sides_of(const PairPose& shown) { sides_ = shown; }

  /// n . (p - q) >= r_1 + r_2 - allowed for the closest points p, q of near capsules at `iterate`, the most
  /// pressing `max_rows` of them.
  void add_rows(const PairPose& iterate, std::vector<ConstraintRow>& rows);

  /// Deepest overlap at a pose beyond what the selected pair allows [m]; 0 when there is none.
  double deepest_excess_m(const PairPose& pose);

  /// Overlaps at a result: those deeper than 0, deepest first. The excess is that over the recording.
  void measure(const PairPose& result, std::vector<CapsuleContact>& contacts, double& deepest_m,
               double& deepest_excess_m);

 private:
  struct NearPair {
    int active_bone = 0;
    int passive_bone = 0;
    double excess = 0;  ///< depth beyond the allowed; negative = room left [m]
    double s = 0, t = 0;
    Vec3 normal = Vec3::Zero();
    double depth = 0;
  };
  using BonePairValues = std::array<std::array<double, bone_count>, bone_count>;

  void find_near(const PairPose& pose, double gap_m);

  CapsuleRadii active_{};
  CapsuleRadii passive_{};
  double clearance_m_ = 0;
  PairPose sides_ = PairPose::Zero();  ///< on which a capsule is of another
  BonePairValues recorded_depth_{};
  BonePairValues allowed_depth_{};
  std::array<std::array<bool, bone_count>, bone_count> held_{};
  std::vector<NearPair> near_;
};

}  // namespace abrazo
