#pragma once

#include <vector>

#include "core/base/progress.hpp"
#include "core/choreography/choreography_options.hpp"
#include "core/library/takes/paired_take.hpp"

namespace abrazo {

/// Sparring in the manner of kickboxing. Whoever attacks is active; neutral footwork belongs to the one who
/// attacks next. Labels tile a take: punch_block, punch_dodge, kick_block, kick_dodge, and guard (at least
/// 0.4 s); the detail says which blow, which defence and who attacks. Blows that are blocked stop at the
/// guard, the others go through where the target was.
/// @param progress  told of every take; when it says stop, the takes so far are returned
/// @throws std::invalid_argument as `check_options`, and when the pace is not between 0.5 and 1.5
std::vector<PairedTake> generate_fight(const ChoreographyOptions& options, const Progress& progress = {});

}  // namespace abrazo
