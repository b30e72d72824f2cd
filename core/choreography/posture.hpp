#pragma once

#include <Eigen/Geometry>

#include "core/base/positions.hpp"
#include "core/choreography/dancer_body.hpp"

namespace abrazo {

enum class Side { Left, Right };

/// +1 on the left, where x is positive.
constexpr double sign_of(Side side) {
  return side == Side::Left ? 1.0 : -1.0;
}

/// Orientation of a body segment [rad]. Yaw 0 faces +Z, positive turns left; pitch positive leans forward;
/// roll positive raises the left side. Yaw is not wrapped.
struct Turn {
  double yaw = 0, pitch = 0, roll = 0;
  Eigen::Matrix3d matrix() const;
};

/// Everything of a dancer but arms and legs.
struct TrunkPosture {
  Vec3 root = Vec3::Zero();
  Turn pelvis, chest, head;
};

struct FootPosture {
  Vec3 toe_base = Vec3::Zero();
  double yaw = 0;
  double heel_pitch = 0;  ///< heel raised by pivoting about the toe-base [rad]
  double toe_pitch = 0;   ///< toes pointing down (in the air) [rad]
};

struct HandTarget {
  Vec3 hand = Vec3::Zero();      ///< where the end of the hand should be
  Vec3 pointing = Vec3::Zero();  ///< bends the wrist towards this direction; zero leaves it straight
};

/// Root, hips, spine, neck, head, shoulders.
void place_trunk(const DancerBody& body, const TrunkPosture& trunk, Pose& pose);

/// Ankle as the foot posture has it.
Vec3 ankle_position(const DancerBody& body, const FootPosture& foot);

/// Knee, ankle, toe-base and toe-tip. The hips must have been placed within reach; the knee points forward.
void place_leg(const DancerBody& body, Side side, const FootPosture& foot, double pelvis_yaw, Pose& pose);

/// Elbow, wrist and hand. The shoulders must have been placed. A target out of reach is only reached for.
void place_arm(const DancerBody& body, Side side, const HandTarget& target, const Turn& chest, Pose& pose);

}  // namespace abrazo
