#pragma once

#include <span>

#include "core/mesh/laplacian.hpp"
#include "core/synthesis/frames/frame_result.hpp"

namespace abrazo {

/// Adds k/2 |(v_b - v_a) - offset|^2 to an energy whose gradient is K V - R.
/// @param[in,out] energy  K
/// @param[in,out] linear  R
void add_spring(int a, int b, double stiffness, const Vec3& offset, VertexMatrix& energy, PairPose& linear);

/// Adds w_H/2 |(v_S - v_A) - offset|^2 for each hold, by its strength.
void add_hold_springs(std::span<const HandHold> holds, double weight, VertexMatrix& energy, PairPose& linear);

}  // namespace abrazo
