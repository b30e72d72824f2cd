#pragma once

#include <string_view>
#include <vector>

#include "core/choreography/fighter.hpp"
#include "core/choreography/random_source.hpp"

namespace abrazo {

enum class Technique { Jab, Cross, Hook, FrontKick, RoundKick };
enum class Defence { Parry, HighGuard, Slip, Duck, ParryDown, ShinCheck, ArmCheck, StepBack, LeanBack };

/// "jab", "high guard", ... as in the detail of a label.
std::string_view name_of(Technique technique);
std::string_view name_of(Defence defence);

constexpr bool is_kick(Technique technique) {
  return technique == Technique::FrontKick || technique == Technique::RoundKick;
}
/// Whether the blow is stopped by a limb; otherwise it misses.
constexpr bool is_block(Defence defence) {
  return defence == Defence::Parry || defence == Defence::HighGuard || defence == Defence::ParryDown ||
         defence == Defence::ShinCheck || defence == Defence::ArmCheck;
}
/// punch_block, punch_dodge, kick_block or kick_dodge
std::string_view label_of(Technique technique, Defence defence);

/// Execution of a technique from the guard with the left foot in front. Trunk offsets at the blow are
/// relative to the guard; the hips lead, the shoulders follow.
struct TechniqueForm {
  Side limb = Side::Left;
  TrunkOffsets hips = TrunkOffsets::Zero(), shoulders = TrunkOffsets::Zero();
  double lead_s = 0;                     ///< from the first movement until the hand (or foot) leaves
  double recovery_s = 0;                 ///< of the limb
  double speed_low = 0, speed_high = 0;  ///< peak speed of the limb relative to the trunk [m/s]
  double stretch = 0.95;                 ///< of the limb on arrival, as a share of its length
  Side pivot = Side::Left;
  double pivot_yaw = 0;  ///< of the standing foot on its ball [rad]; 0 = none
};
TechniqueForm form_of(Technique technique);

/// Trunk offsets that evade or meet a blow, relative to the guard.
TrunkOffsets trunk_of(Defence defence, Technique against);

/// A blow and its defence.
struct Attack {
  Technique technique = Technique::Jab;
  Defence defence = Defence::Parry;
};

/// One to three blows in a row.
std::vector<Attack> draw_combination(RandomSource& random);

}  // namespace abrazo
