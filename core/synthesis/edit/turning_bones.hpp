#pragma once

#include "core/base/positions.hpp"
#include "core/synthesis/edit/constrained_solver.hpp"
#include "core/synthesis/edit/constraints.hpp"

namespace abrazo {

/// Stiffens the energy of the next solve across the bones that the last one turned hard. A bone row is
/// linear, so a bone pulled hard towards a far point turns too far: by d/l times the angle it should, for a
/// target at d. The exact second derivative of the length constraint, |multiplier| / l across the bone,
/// prevents that; it is added in all directions, about the current iterate, where it matters.
/// @param solved   whether the solver has multipliers, of rows that begin with these lengths
/// @param[in,out] linear  R
void damp_turning_bones(const RigidDistances& lengths, const PairPose& iterate, bool solved,
                        ConstrainedSolver& solver, PairPose& linear);

}  // namespace abrazo
