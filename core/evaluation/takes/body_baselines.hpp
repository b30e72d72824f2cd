#pragma once

#include <vector>

#include "core/bodies/pair_retargeting.hpp"

namespace abrazo {

/// What a recorded pair on other bodies is compared with.

/// Inverse kinematics of hands and feet only: the pair rebuilt on its steps, hands brought to where the
/// recording has them, scaled as the common path is.
std::vector<PairPose> by_inverse_kinematics(const RecordedPair& recorded, const PairBodies& bodies);

/// The interaction mesh of the paper as printed, frame after frame: the active body retargeted without its
/// partner (3.3.1), the recorded pair stood at its root and edited (3.4) with the settings of `paper`, which
/// knows one size of contact, the recorded. Joints of a failed frame stay where they were.
std::vector<PairPose> by_mesh_of_the_paper(const RecordedPair& recorded, const PairBodies& bodies);

}  // namespace abrazo
