#pragma once

#include "core/choreography/fight_technique.hpp"
#include "core/choreography/fighter.hpp"

namespace abrazo {

/// Distance from which a blow arrives well stretched at a fighter in guard.
struct StrikeReach {
  double distance = 0;  ///< between the spots of the two [m]
  double path = 0;      ///< path length of the hand from the guard, or of the foot from its drawn-up position
                        ///< [m]
};
StrikeReach strike_reach(const Fighter& attacker, const Fighter& defender, const Attack& attack);

/// Target of a blow on a fighter in guard on a spot: the head (of a taller one the chin), the belly, or the
/// middle of the trunk (or thigh) at the height of the kick.
/// @param highest highest possible target [m]
Vec3 aim_at(const Fighter& defender, const Spot& spot, const Attack& attack, double highest);

/// Highest target of the attacker's punch or kick [m].
double highest_strike(const Fighter& attacker, Technique technique);

/// The attacker's trunk at the blow, beyond the guard: hips, shoulders.
struct StrikeTrunk {
  TrunkOffsets hips, shoulders;
};
StrikeTrunk strike_trunk(const Fighter& attacker, const TechniqueForm& form);

/// The drawn-up form of a kick, without target and times.
LegMove kick_form(const DancerBody& body, Technique technique);
/// The same for the leg that is raised against a round kick.
LegMove check_form(const DancerBody& body);

/// Distance from the target at which a blocked blow ends [m].
double stops_short(Defence defence);

}  // namespace abrazo
