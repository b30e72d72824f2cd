#pragma once

#include "core/motion/body/body.hpp"
#include "core/stream/humanoid/humanoid_points.hpp"
#include "core/stream/humanoid/limb_ends.hpp"

namespace abrazo {

/// Places and turns of a humanoid's bones in the world; those it does not have are as their parent.
PerBone<SegmentPose> world_segments(const HumanoidPose& pose);

/// The 25 joints of a body that stands in a T-pose, facing +Z, its toes at their rest height.
Pose t_pose(const Body& body);

}  // namespace abrazo
