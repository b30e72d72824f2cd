#pragma once

#include <span>

#include "core/evaluation/tables/evaluation.hpp"
#include "core/evaluation/takes/take_synthesis.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/metrics/zmp.hpp"

namespace abrazo {

/// Table IV: both bodies of the takes as they were captured and as they came out, at the same frames with the
/// same settings.
ZmpTable measure_zmp(std::span<const SynthesisedTake> takes, const ZmpSettings& settings);

/// Holds and penetration against the selected pairs, foot sliding against the capture, bone lengths, foot
/// locks.
ContactTable measure_contact(std::span<const SynthesisedTake> takes, const MotionLibrary& library);

/// The partner against the captured one, and how it moves.
PartnerTable measure_partner(std::span<const SynthesisedTake> takes);

SolveTimes measure_solve_times(std::span<const SynthesisedTake> takes);

}  // namespace abrazo
