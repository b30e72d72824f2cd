#pragma once

#include "core/choreography/fight_score.hpp"

namespace abrazo {

/// Gives a blow its target and the defence its place, when trunk and feet of both are complete: a blow that
/// is blocked ends at the limb that blocks it, another goes through where its target was when it began.
void write_contact(const Blow& blow, Fighter& attacker, Fighter& defender);

}  // namespace abrazo
