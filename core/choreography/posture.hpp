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

/// Posture of a dancer without arms and legs.
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
  Vec3 hand = Vec3::Zero();      ///< target of the end of the hand
  Vec3 pointing = Vec3::Zero();  ///< bends the wrist towards this direction; zero leaves it straight
};

/// Root, hips, spine, neck, head, shoulders.
void place_trunk(const DancerBody& body, const TrunkPosture& trunk, Pose& pose);

/// Position of the ankle for a foot posture.
Vec3 ankle_position(const DancerBody& body, const FootPosture& foot);

/// Knee, ankle, toe-base and toe-tip. The hips must be placed within reach; the knee points forward.
void place_leg(const DancerBody& body, Side side, const FootPosture& foot, double pelvis_yaw, Pose& pose);

/// Elbow, wrist and hand. The shoulders must be placed. The arm points towards a target out of reach.
void place_arm(const DancerBody& body, Side side, const HandTarget& target, const Turn& chest, Pose& pose);

}  // namespace abrazo
