#pragma once

#include <array>
#include <vector>

#include "core/base/positions.hpp"
#include "core/synthesis/edit/constraints.hpp"
#include "core/synthesis/frames/frame_result.hpp"

namespace abrazo {

/// Input for one foot in one frame.
struct FootSituation {
  bool landed =
      false;  ///< near the floor (and slow, where speed counts): of the user, or of the selected partner
  Vec3 hip = Vec3::Zero();       ///< desired position of the hip, world
  Vec3 toe_base = Vec3::Zero();  ///< desired position of the toe base, world
  double leg_length = 0;         ///< hip to ankle of a straight leg [m]
};

/// Anti-foot-sliding (Eq. 10): a foot that was landed in the previous frame and still is stays where it was.
/// Ankle and toe base are held, the toe tip is not, so the foot can roll. A lock is released when the foot
/// lifts, when its desired position is too far away, or when the leg would be overstretched.
class FootLocks {
 public:
  /// Feet in the order active left, active right, passive left, passive right.
  using Situations = std::array<FootSituation, 4>;

  void reset();

  /// Updates the locks for a frame. @param previous the previous result; null at the start
  /// @param source_changed  the selected pair does not continue the previous one: a foot is then only held
  /// within 10 cm
  void update(const Situations& feet, const PairPose* previous, bool source_changed);

  /// Adds the rows of the locked feet. @param bodies which: 0 none, 1 active only, 2 both
  void add_rows(int bodies, std::vector<ConstraintRow>& rows) const;

  /// Number of locked feet.
  int held(int bodies) const;

  /// Releases the locks of bodies beyond the first `bodies`, which could not be satisfied.
  void release(int bodies);

  void list(int bodies, std::vector<FootLock>& locks) const;
  /// Largest distance of a locked vertex from its locked position [m].
  double drift(int bodies, const PairPose& positions) const;

  /// Feet of the partner that were locked in the previous frame and are now released.
  const std::array<bool, 2>& passive_released() const { return passive_released_; }

  static constexpr std::array<int, 4> ankles = {3, 8, 28, 33};  ///< vertices

  struct Foot {
    bool was_landed = false;
    bool locked = false;
    Vec3 ankle = Vec3::Zero();
    Vec3 toe_base = Vec3::Zero();
  };
  /// State, for serialisation.
  FootLocks() = default;
  FootLocks(const std::array<Foot, 4>& feet, const std::array<bool, 2>& passive_released)
      : feet_(feet), passive_released_(passive_released) {}
  const std::array<Foot, 4>& feet() const { return feet_; }

 private:
  static bool may_be_held(const FootSituation& wanted, const Foot& foot, double farthest_m);

  std::array<Foot, 4> feet_;
  std::array<bool, 2> passive_released_{};
};

}  // namespace abrazo
