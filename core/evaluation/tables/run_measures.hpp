#pragma once

#include <span>

#include "core/evaluation/tables/evaluation.hpp"
#include "core/evaluation/takes/take_synthesis.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/metrics/zmp.hpp"

namespace abrazo {

/// Table IV: both bodies of the takes, captured and synthesised, at the same frames with the
/// same settings.
ZmpTable measure_zmp(std::span<const SynthesisedTake> takes, const ZmpSettings& settings);

/// Holds and penetration relative to the selected pairs, foot sliding relative to the capture, bone lengths,
/// foot locks.
ContactTable measure_contact(std::span<const SynthesisedTake> takes, const MotionLibrary& library);

/// Distance of the partner from the captured one, and its motion.
PartnerTable measure_partner(std::span<const SynthesisedTake> takes);

SolveTimes measure_solve_times(std::span<const SynthesisedTake> takes);

}  // namespace abrazo
