#pragma once

#include <span>

#include "core/mesh/laplacian.hpp"
#include "core/synthesis/frames/frame_result.hpp"

namespace abrazo {

/// Adds w_H/2 |(v_S - v_A) - offset|^2 for each hold, by its strength, to an energy whose gradient is
/// K V - R.
/// @param[in,out] energy  K
/// @param[in,out] linear  R
void add_hold_springs(std::span<const HandHold> holds, double weight, VertexMatrix& energy, PairPose& linear);

}  // namespace abrazo
