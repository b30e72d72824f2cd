#include "core/choreography/strike_reach.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/positions.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {
namespace {

using namespace joints;

/// The point of the spine at a height; vertically below the root for lower heights.
Vec3 spine_at(const Pose& pose, double height) {
  static constexpr std::array<int, 6> spine = {Root, LowerBack, UpperBack, Thorax, LowerNeck, UpperNeck};
  Vec3 below = joint_at(pose, Root);
  if (height <= below.y()) return {below.x(), height, below.z()};
  for (const int joint : spine) {
    const Vec3 above = joint_at(pose, joint);
    if (above.y() > height) return below + (above - below) * ((height - below.y()) / (above.y() - below.y()));
    below = above;
  }
  return below;
}

int base_joint(const TechniqueForm& form, bool kick) {
  if (kick) return form.limb == Side::Left ? left_hip : right_hip;
  return form.limb == Side::Left ? left_shoulder : right_shoulder;
}

}  // namespace

Vec3 aim_at(const Fighter& defender, const Spot& spot, const Attack& attack, double highest) {
  const Pose pose = defender.trunk_on(spot, guard_stance()).pose;
  const double h = defender.body().height;
  if (!is_kick(attack.technique)) {
    const Vec3 chin = joint_at(pose, UpperNeck), head = joint_at(pose, Head);
    return chin + std::clamp((highest - chin.y()) / (head.y() - chin.y()), 0.2, 1.0) * (head - chin);
  }
  if (attack.technique == Technique::FrontKick)
    return joint_at(pose, LowerBack) + 0.06 * forward_of(spot.heading);
  const double height = attack.defence == Defence::ShinCheck  ? 0.42 * h
                        : attack.defence == Defence::ArmCheck ? 0.67 * h
                                                              : 0.74 * h;
  return spine_at(pose, std::min(height, highest));
}

double highest_strike(const Fighter& attacker, Technique technique) {
  const DancerBody& body = attacker.body();
  if (is_kick(technique)) return body.standing_root_height(0.95) + 0.45 * body.leg();
  const Pose guard = attacker.trunk_on({}, guard_stance()).pose;
  return guard(left_shoulder, 1) + 0.35 * (body.upper_arm + body.forearm);
}

StrikeTrunk strike_trunk(const Fighter& attacker, const TechniqueForm& form) {
  const double size = attacker.body().height / 1.75;
  StrikeTrunk trunk{form.hips * attacker.performance().amplitude,
                    form.shoulders * attacker.performance().amplitude};
  // The weight must come over the standing foot however small the kick is.
  trunk.hips.head<3>() = form.hips.head<3>() * size;
  return trunk;
}

double stops_short(Defence defence) {
  switch (defence) {
    case Defence::Parry:
    case Defence::HighGuard:
      return 0.20;
    case Defence::ParryDown:
      return 0.27;
    case Defence::ArmCheck:
      return 0.22;
    case Defence::ShinCheck:
      return 0.12;
    case Defence::Slip:
    case Defence::StepBack:
      return -0.08;
    case Defence::Duck:
    case Defence::LeanBack:
      return 0;
  }
  return 0;
}

StrikeReach strike_reach(const Fighter& attacker, const Fighter& defender, const Attack& attack) {
  const TechniqueForm form = form_of(attack.technique);
  const bool kick = is_kick(attack.technique);
  const DancerBody& body = attacker.body();
  const StrikeTrunk offsets = strike_trunk(attacker, form);
  const PlacedTrunk trunk = attacker.trunk_on({}, guard_stance() + offsets.hips + offsets.shoulders);
  const Vec3 base = joint_at(trunk.pose, base_joint(form, kick));
  const double limb = kick ? body.leg() : body.upper_arm + body.forearm + body.hand;
  // Less than fully stretched when performed small, or when it ends at a guard.
  const double stretch = form.stretch * (is_block(attack.defence) ? 0.90 : 1);
  const double reach = limb * stretch * (0.85 + 0.15 * std::min(1.0, attacker.performance().amplitude));
  // The other faces the attacker, so his left is the attacker's right.
  const Vec3 seen = aim_at(defender, {}, attack, highest_strike(attacker, attack.technique));
  const double aside = -seen.x() - base.x(), up = seen.y() - base.y();
  const double ahead = std::sqrt(std::max(0.09 * limb * limb, reach * reach - aside * aside - up * up));
  StrikeReach found{.distance = base.z() + ahead + seen.z() + stops_short(attack.defence)};
  const Vec3 end = base + Vec3(aside, up, ahead);
  const Vec3 from =
      kick ? Vec3(base + trunk.posture.pelvis.matrix() * kick_form(body, attack.technique).drawn_up)
           : attacker.guard_hand(form.limb, attacker.trunk_on({}, guard_stance()), 0);
  found.path = std::max(0.2, (end - from).norm());
  return found;
}

LegMove kick_form(const DancerBody& body, Technique technique) {
  LegMove move;
  if (technique == Technique::FrontKick) {
    move.drawn_up = body.leg() * Vec3(-0.02, -0.36, 0.36);
    move.hinge = Vec3::UnitX();
    move.pointed = 0.15;
  } else {
    move.drawn_up = body.leg() * Vec3(-0.34, -0.30, -0.20);
    move.hinge = Vec3(0.6, -0.8, 0);
    move.pointed = 0.9;
  }
  return move;
}

LegMove check_form(const DancerBody& body) {
  return {.drawn_up = body.leg() * Vec3(0.10, -0.52, 0.24), .hinge = Vec3(0.88, 0, -0.48), .pointed = 0.3};
}

}  // namespace abrazo
