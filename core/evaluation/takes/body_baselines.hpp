#pragma once

#include <vector>

#include "core/bodies/pair_retargeting.hpp"

namespace abrazo {

/// Baselines for a recorded pair on other bodies.

/// Inverse kinematics of hands and feet only: the pair rebuilt on its steps, hands moved to their recorded
/// places, scaled like the common path.
std::vector<PairPose> by_inverse_kinematics(const RecordedPair& recorded, const PairBodies& bodies);

/// The interaction mesh of the paper as printed, frame after frame: the active body retargeted without its
/// partner (3.3.1), the recorded pair placed at its root and edited (3.4) with the settings of `paper`, whose
/// contacts have the recorded size. In a failed frame joints stay.
std::vector<PairPose> by_mesh_of_the_paper(const RecordedPair& recorded, const PairBodies& bodies);

}  // namespace abrazo
