#include "core/choreography/fight_technique.hpp"

#include <array>
#include <numbers>

#include "core/base/units.hpp"

namespace abrazo {
namespace {

/// How often a technique is met by this defence.
struct Choice {
  double share;
  Defence defence;
};

Defence draw_defence(Technique against, RandomSource& random) {
  const auto draw = [&](std::initializer_list<Choice> choices) {
    double left = random.uniform(0, 1);
    for (const Choice& choice : choices)
      if ((left -= choice.share) < 0) return choice.defence;
    return (choices.end() - 1)->defence;
  };
  switch (against) {
    case Technique::Jab:
      return draw({{0.72, Defence::Parry}, {0.28, Defence::Slip}});
    case Technique::Cross:
      return draw({{0.70, Defence::Slip}, {0.30, Defence::HighGuard}});
    case Technique::Hook:
      return draw({{0.74, Defence::Duck}, {0.26, Defence::HighGuard}});
    case Technique::FrontKick:
      return draw({{0.55, Defence::ParryDown}, {0.45, Defence::StepBack}});
    case Technique::RoundKick:
      return draw({{0.36, Defence::ShinCheck}, {0.26, Defence::ArmCheck}, {0.38, Defence::LeanBack}});
  }
  return Defence::Parry;
}

TechniqueForm jab() {
  TechniqueForm form{.limb = Side::Left, .hips = TrunkOffsets::Zero(), .shoulders = TrunkOffsets::Zero()};
  form.hips[Forward] = 0.07, form.hips[PelvisYaw] = -5 * radians_per_degree,
  form.hips[RightHeel] = 8 * radians_per_degree;
  form.shoulders[ChestYaw] = -14 * radians_per_degree, form.shoulders[ChestLean] = 4 * radians_per_degree;
  form.lead_s = 0.13, form.recovery_s = 0.30;
  form.speed_low = 5.4, form.speed_high = 6.3;
  return form;
}

TechniqueForm cross() {
  TechniqueForm form{.limb = Side::Right, .hips = TrunkOffsets::Zero(), .shoulders = TrunkOffsets::Zero()};
  form.hips[Forward] = 0.09, form.hips[Leftward] = 0.02, form.hips[PelvisYaw] = 42 * radians_per_degree;
  form.hips[RightHeel] = 16 * radians_per_degree;
  form.shoulders[ChestYaw] = 70 * radians_per_degree, form.shoulders[ChestLean] = 6 * radians_per_degree;
  form.lead_s = 0.14, form.recovery_s = 0.36;
  form.speed_low = 6.8, form.speed_high = 7.8;
  form.pivot = Side::Right, form.pivot_yaw = 38 * radians_per_degree;
  return form;
}

TechniqueForm hook() {
  TechniqueForm form{.limb = Side::Left, .hips = TrunkOffsets::Zero(), .shoulders = TrunkOffsets::Zero()};
  form.hips[Forward] = 0.05, form.hips[PelvisYaw] = -22 * radians_per_degree,
  form.hips[LeftHeel] = 14 * radians_per_degree;
  form.shoulders[ChestYaw] = -34 * radians_per_degree, form.shoulders[ChestLean] = 2 * radians_per_degree;
  form.lead_s = 0.24, form.recovery_s = 0.38;
  form.speed_low = 5.4, form.speed_high = 6.4;
  form.stretch = 0.80;
  form.pivot = Side::Left, form.pivot_yaw = -34 * radians_per_degree;
  return form;
}

TechniqueForm front_kick() {
  TechniqueForm form{.limb = Side::Right, .hips = TrunkOffsets::Zero(), .shoulders = TrunkOffsets::Zero()};
  form.hips[Forward] = 0.16, form.hips[Leftward] = 0.06, form.hips[Upward] = 0.03;
  form.hips[PelvisYaw] = 34 * radians_per_degree, form.hips[PelvisLean] = -14 * radians_per_degree;
  form.shoulders[ChestYaw] = 26 * radians_per_degree, form.shoulders[ChestLean] = -22 * radians_per_degree;
  form.shoulders[HeadLean] = -6 * radians_per_degree;
  form.lead_s = 0.16, form.recovery_s = 0.32;
  form.speed_low = 4.6, form.speed_high = 5.8;
  form.pivot = Side::Left, form.pivot_yaw = 18 * radians_per_degree;
  return form;
}

TechniqueForm round_kick() {
  TechniqueForm form{.limb = Side::Right, .hips = TrunkOffsets::Zero(), .shoulders = TrunkOffsets::Zero()};
  form.hips[Forward] = 0.17, form.hips[Leftward] = 0.05, form.hips[Upward] = 0.02;
  form.hips[PelvisYaw] = 98 * radians_per_degree, form.hips[PelvisLean] = -24 * radians_per_degree;
  form.shoulders[ChestYaw] = 74 * radians_per_degree, form.shoulders[ChestLean] = -26 * radians_per_degree;
  form.shoulders[ChestTilt] = 10 * radians_per_degree, form.shoulders[HeadLean] = -4 * radians_per_degree;
  form.lead_s = 0.16, form.recovery_s = 0.34;
  form.speed_low = 5.5, form.speed_high = 6.4;
  form.pivot = Side::Left, form.pivot_yaw = 72 * radians_per_degree;
  return form;
}

}  // namespace

std::string_view name_of(Technique technique) {
  static constexpr std::array<std::string_view, 5> names = {"jab", "cross", "hook", "front kick",
                                                            "round kick"};
  return names[static_cast<std::size_t>(technique)];
}

std::string_view name_of(Defence defence) {
  static constexpr std::array<std::string_view, 9> names = {"parry",     "high guard", "slip",
                                                            "duck",      "parry down", "shin check",
                                                            "arm check", "step back",  "lean back"};
  return names[static_cast<std::size_t>(defence)];
}

std::string_view label_of(Technique technique, Defence defence) {
  if (is_kick(technique)) return is_block(defence) ? "kick_block" : "kick_dodge";
  return is_block(defence) ? "punch_block" : "punch_dodge";
}

TechniqueForm form_of(Technique technique) {
  switch (technique) {
    case Technique::Jab:
      return jab();
    case Technique::Cross:
      return cross();
    case Technique::Hook:
      return hook();
    case Technique::FrontKick:
      return front_kick();
    case Technique::RoundKick:
      return round_kick();
  }
  return jab();
}

TrunkOffsets trunk_of(Defence defence, Technique against) {
  TrunkOffsets trunk = TrunkOffsets::Zero();
  // Outside the arm: away from it and beside it.
  const double outside = against == Technique::Cross ? 1 : -1;
  switch (defence) {
    case Defence::Slip:
      trunk[Leftward] = outside * 0.07, trunk[Upward] = -0.04;
      trunk[PelvisTilt] = outside * 9 * radians_per_degree,
      trunk[ChestTilt] = outside * 23 * radians_per_degree;
      trunk[PelvisYaw] = outside * 8 * radians_per_degree,
      trunk[ChestYaw] = outside * 20 * radians_per_degree;
      trunk[ChestLean] = 7 * radians_per_degree;
      break;
    case Defence::Duck:
      trunk[Upward] = -0.25, trunk[Forward] = -0.11, trunk[Leftward] = 0.08;
      trunk[PelvisLean] = 16 * radians_per_degree, trunk[ChestLean] = 27 * radians_per_degree,
      trunk[HeadLean] = 4 * radians_per_degree;
      trunk[ChestTilt] = 6 * radians_per_degree;
      break;
    case Defence::LeanBack:
      trunk[Forward] = -0.13, trunk[Upward] = -0.03;
      trunk[PelvisLean] = -10 * radians_per_degree, trunk[ChestLean] = -32 * radians_per_degree,
      trunk[HeadLean] = -10 * radians_per_degree;
      trunk[ChestYaw] = -10 * radians_per_degree, trunk[LeftHeel] = 6 * radians_per_degree;
      break;
    case Defence::StepBack:
      trunk[Forward] = -0.05, trunk[ChestLean] = 9 * radians_per_degree,
      trunk[PelvisLean] = 6 * radians_per_degree;
      break;
    case Defence::Parry:
      trunk[ChestYaw] = 12 * radians_per_degree, trunk[Forward] = -0.02;
      break;
    case Defence::HighGuard:
      trunk[Upward] = -0.04, trunk[ChestLean] = 5 * radians_per_degree,
      trunk[HeadLean] = 5 * radians_per_degree;
      trunk[ChestYaw] = against == Technique::Hook ? 10 * radians_per_degree : -4 * radians_per_degree;
      break;
    case Defence::ParryDown:
      trunk[Forward] = -0.05, trunk[Upward] = -0.04, trunk[ChestLean] = 7 * radians_per_degree;
      trunk[ChestYaw] = -8 * radians_per_degree;
      break;
    case Defence::ShinCheck:
      // All the weight on the rear leg.
      trunk[Forward] = -0.24, trunk[Leftward] = -0.11, trunk[PelvisYaw] = 10 * radians_per_degree;
      trunk[ChestYaw] = 12 * radians_per_degree, trunk[ChestLean] = -8 * radians_per_degree,
      trunk[RightHeel] = -14 * radians_per_degree;
      break;
    case Defence::ArmCheck:
      trunk[Upward] = -0.03, trunk[ChestTilt] = 7 * radians_per_degree,
      trunk[ChestYaw] = 16 * radians_per_degree;
      trunk[Forward] = -0.02;
      break;
  }
  return trunk;
}

std::vector<Attack> draw_combination(RandomSource& random) {
  using enum Technique;
  struct Combination {
    double share;
    std::vector<Technique> blows;
  };
  static const std::array<Combination, 9> combinations = {{{0.13, {Jab}},
                                                           {0.09, {Cross}},
                                                           {0.11, {Hook}},
                                                           {0.17, {FrontKick}},
                                                           {0.18, {RoundKick}},
                                                           {0.12, {Jab, Cross}},
                                                           {0.07, {Jab, Cross, Hook}},
                                                           {0.08, {Cross, RoundKick}},
                                                           {0.05, {Jab, FrontKick}}}};
  double left = random.uniform(0, 1);
  std::vector<Technique> chosen = combinations.front().blows;
  for (const Combination& combination : combinations)
    if ((left -= combination.share) < 0) {
      chosen = combination.blows;
      break;
    }
  std::vector<Attack> attacks;
  for (const Technique technique : chosen) {
    Defence defence = draw_defence(technique, random);
    // From one slip straight into another to the other side is too far.
    if (!attacks.empty() && attacks.back().defence == Defence::Slip && defence == Defence::Slip)
      defence = Defence::HighGuard;
    attacks.push_back({technique, defence});
  }
  return attacks;
}

}  // namespace abrazo
