#pragma once

#include "core/motion/body/body.hpp"
#include "core/stream/humanoid/humanoid_points.hpp"
#include "core/stream/humanoid/limb_ends.hpp"

namespace abrazo {

/// Positions and rotations of a humanoid's bones in the world; missing bones are as their parent.
PerBone<SegmentPose> world_segments(const HumanoidPose& pose);

/// The 25 joints of a body in a T-pose facing +Z, with toes at rest height.
Pose t_pose(const Body& body);

}  // namespace abrazo
