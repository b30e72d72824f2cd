#pragma once

#include <memory>
#include <vector>

#include "core/evaluation/run/evaluate.hpp"
#include "core/evaluation/takes/take_synthesis.hpp"

namespace abrazo::test {

/// Three swinging takes, performer A active, with their library.
EvaluationData three_takes();

/// As if every frame of the take had been answered with `pairs[frame]` and the result were the capture
/// itself, the partner moved by `partner_offset`.
SynthesisedTake answered(const PairedTake& take, const std::vector<int>& pairs,
                         const Vec3& partner_offset = Vec3::Zero());

/// The pair of each frame of a take of the library.
std::vector<int> own_pairs(const MotionLibrary& library, const PairedTake& take);

}  // namespace abrazo::test
