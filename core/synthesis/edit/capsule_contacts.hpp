#pragma once

#include <array>
#include <vector>

#include "core/base/positions.hpp"
#include "core/mesh/capsules.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/synthesis/edit/constraints.hpp"
#include "core/synthesis/frames/frame_result.hpp"

namespace abrazo {

/// Keeps the capsules of the two bodies apart as far as in the selected pair: recorded contact is allowed, so
/// two capsules may overlap by their depth in the selected pair. Hands and forearms of arms that hold one
/// another there are ignored.
class CapsuleContacts {
 public:
  /// Capsules closer than this get a constraint row [m].
  static constexpr double activation_gap_m = 0.05;
  static constexpr int max_rows = 16;

  CapsuleContacts();

  /// Computes the overlaps that the selected pair allows, with the radii of the two bodies.
  /// @param clearance_m additional distance to keep
  void prepare(const PairPose& selected, const CapsuleRadii& active, const CapsuleRadii& passive,
               double clearance_m = 0);
  /// The radii of the bodies that are kept apart, where they are not those of the selected pair.
  void wear(const CapsuleRadii& active, const CapsuleRadii& passive) {
    active_ = active;
    passive_ = passive;
  }
  /// Capsules whose axes have passed through one another are pushed back to their side in `shown`, instead of
  /// the side in the selected pair, so that the shown bodies do not jump through one another.
  void keep_sides_of(const PairPose& shown) { sides_ = shown; }

  /// n . (p - q) >= r_1 + r_2 - allowed for the closest points p, q of near capsules at `iterate`; at most
  /// `max_rows`, those with the deepest overlap.
  void add_rows(const PairPose& iterate, std::vector<ConstraintRow>& rows);

  /// Deepest overlap at a pose beyond the allowed one [m]; 0 if there is none.
  double deepest_excess_m(const PairPose& pose);

  /// Overlaps deeper than 0 at a result, deepest first. The excess is relative to the recording.
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
  PairPose sides_ = PairPose::Zero();  ///< pose that defines the side of each capsule
  BonePairValues recorded_depth_{};
  BonePairValues allowed_depth_{};
  std::array<std::array<bool, bone_count>, bone_count> held_{};
  std::vector<NearPair> near_;
};

}  // namespace abrazo
