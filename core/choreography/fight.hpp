#pragma once

#include <vector>

#include "core/base/progress.hpp"
#include "core/choreography/choreography_options.hpp"
#include "core/library/takes/paired_take.hpp"

namespace abrazo {

/// Sparring in the manner of kickboxing. The attacker is active; neutral footwork belongs to the next
/// attacker. Labels tile a take: punch_block, punch_dodge, kick_block, kick_dodge, and guard (at least
/// 0.4 s); the detail gives blow, defence and attacker. Blocked blows stop at the guard; the others go
/// through the target's initial position.
/// @param progress called for every take; after cancellation the takes so far are returned
/// @throws std::invalid_argument as `check_options`, and if the pace is not between 0.5 and 1.5
std::vector<PairedTake> generate_fight(const ChoreographyOptions& options, const Progress& progress = {});

}  // namespace abrazo
