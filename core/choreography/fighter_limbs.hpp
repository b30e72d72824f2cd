#pragma once

#include <Eigen/Geometry>

#include "core/choreography/dancer_body.hpp"
#include "core/choreography/posture.hpp"

namespace abrazo {

/// The arm of a fist: wrist straight. The shoulders must be placed; the arm points towards a target out of
/// reach.
/// @param elbow direction of the elbow, chest space of the left arm (mirrored for the right)
void place_fist(const DancerBody& body, Side side, const Vec3& hand, const Vec3& elbow, const Turn& chest,
                Pose& pose);

/// A foot off the floor, or on it (`share` 0).
struct LiftedFoot {
  Vec3 ankle = Vec3::Zero();
  Vec3 hinge = Vec3::UnitX();  ///< axis of the knee, world, about to the left
  double pointed = 0;          ///< of the foot from square to the shank [rad]
  double share = 0;            ///< blend from the standing posture to the air; 0 .. 1
};

/// Knee, ankle, toe-base and toe-tip between the standing posture and that in the air.
void place_lifted_leg(const DancerBody& body, Side side, const FootPosture& standing, double pelvis_yaw,
                      const LiftedFoot& lifted, Pose& pose);

}  // namespace abrazo
