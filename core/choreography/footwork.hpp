#pragma once

#include <vector>

#include "core/base/positions.hpp"
#include "core/choreography/posture.hpp"

namespace abrazo {

/// One foot leaves the floor and comes down elsewhere, or (no lift, same place) turns on its ball.
struct FootMove {
  double start = 0, end = 0;     ///< [beats]
  Vec3 toe_base = Vec3::Zero();  ///< where it arrives
  double yaw = 0;                ///< [rad], not wrapped
  double lift = 0;               ///< highest point of the toe-base above its rest [m]
  double heel = 0;               ///< greatest heel pitch on the way [rad]
  Vec3 detour = Vec3::Zero();    ///< off the straight line half way, round the standing foot [m]
};

/// What one foot does over a dance. Between moves it does not move at all.
class Footwork {
 public:
  Footwork(const Vec3& toe_base, double yaw) : start_{.toe_base = toe_base, .yaw = yaw} {}

  /// @throws std::invalid_argument when it begins before the previous move has ended or lasts no time
  void add(const FootMove& move);

  FootPosture at(double beat) const;

  /// Where it stands (or arrives) after everything added so far.
  const FootMove& last() const { return moves_.empty() ? start_ : moves_.back(); }

 private:
  FootMove start_;
  std::vector<FootMove> moves_;  ///< ascending
};

}  // namespace abrazo
