#pragma once

#include "core/choreography/fight_technique.hpp"
#include "core/choreography/fighter.hpp"

namespace abrazo {

/// From where a blow arrives well stretched at a fighter who stands in guard.
struct StrikeReach {
  double distance = 0;  ///< between the spots of the two [m]
  double path = 0;      ///< of the hand from the guard, of the foot from where it is drawn up [m]
};
StrikeReach strike_reach(const Fighter& attacker, const Fighter& defender, const Attack& attack);

/// What a blow is aimed at on a fighter who stands in guard on a spot: the head (of a taller one the chin),
/// the belly, or the middle of the trunk (or thigh) at the height of the kick.
/// @param highest  that the blow can be [m]
Vec3 aim_at(const Fighter& defender, const Spot& spot, const Attack& attack, double highest);

/// How high the attacker punches or kicks [m].
double highest_strike(const Fighter& attacker, Technique technique);

/// The attacker's trunk at the blow, beyond the guard: hips, shoulders.
struct StrikeTrunk {
  TrunkOffsets hips, shoulders;
};
StrikeTrunk strike_trunk(const Fighter& attacker, const TechniqueForm& form);

/// How the foot of a kick is drawn up and held; neither target nor times.
LegMove kick_form(const DancerBody& body, Technique technique);
/// The same for the leg that is raised against a round kick.
LegMove check_form(const DancerBody& body);

/// How far before its target a blow that is blocked ends [m].
double stops_short(Defence defence);

}  // namespace abrazo
