#pragma once

#include "core/choreography/fight_score.hpp"

namespace abrazo {

/// Sets the target of a blow and the position of the defence, after trunk and feet of both are complete: a
/// blocked blow ends at the blocking limb; another goes through the position that its target had at the
/// begin.
void write_contact(const Blow& blow, Fighter& attacker, Fighter& defender);

}  // namespace abrazo
