#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/evaluation/tables/evaluation.hpp"
#include "core/evaluation/takes/take_synthesis.hpp"
#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// Labels that are not moves: standing, walking in, footwork between exchanges.
bool is_move(std::string_view label);

/// The alternative label in a label's detail ("alt=turn"); empty if there is none.
std::string alternative_label(const LabelInterval& label);

/// Table III (Eq. 12) over takes answered by `library`. A step's label is that of the pair it was made from.
/// Where either performer may be the active one (`both_roles`), who attacks belongs to the move:
/// "kick_block (user)" is not "kick_block (partner)". A move without a solved step is not successful.
MoveTable count_moves(std::span<const SynthesisedTake> takes, const MotionLibrary& library, bool both_roles);

}  // namespace abrazo
