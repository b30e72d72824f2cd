#pragma once

#include <vector>

#include "core/base/positions.hpp"
#include "core/choreography/posture.hpp"

namespace abrazo {

/// One foot leaves the floor and lands elsewhere, or (no lift, same place) turns on its ball.
struct FootMove {
  double start = 0, end = 0;     ///< [beats]
  Vec3 toe_base = Vec3::Zero();  ///< position of arrival
  double yaw = 0;                ///< [rad], not wrapped
  double lift = 0;               ///< highest point of the toe-base above its rest [m]
  double heel = 0;               ///< greatest heel pitch on the way [rad]
  Vec3 detour = Vec3::Zero();    ///< deviation from the straight line half-way, around the standing foot [m]
};

/// Moves of one foot over a dance. Between moves it is at rest.
class Footwork {
 public:
  Footwork(const Vec3& toe_base, double yaw) : start_{.toe_base = toe_base, .yaw = yaw} {}

  /// @throws std::invalid_argument if it begins before the end of the previous move or has no duration
  void add(const FootMove& move);

  FootPosture at(double beat) const;

  /// The last move: the foot's position after everything added so far.
  const FootMove& last() const { return moves_.empty() ? start_ : moves_.back(); }

 private:
  FootMove start_;
  std::vector<FootMove> moves_;  ///< ascending
};

}  // namespace abrazo
