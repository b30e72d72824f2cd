#include "core/choreography/strike_contact.hpp"

#include <algorithm>

#include "core/base/positions.hpp"
#include "core/choreography/strike_reach.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {
namespace {

using namespace joints;

constexpr double thickness = 0.050;  ///< of a fist and a forearm, or two shins, between their axes [m]

/// What the limbs of both are directed by at the moment of a blow.
struct Encounter {
  const Blow& blow;
  Fighter& attacker;
  Fighter& defender;
  TechniqueForm form;
  PlacedTrunk striking, defending;
  Vec3 ahead, left;             ///< of the attacker
  Vec3 towards, defender_left;  ///< of the defender

  Encounter(const Blow& which, Fighter& by, Fighter& against)
      : blow(which),
        attacker(by),
        defender(against),
        form(form_of(which.attack.technique)),
        striking(by.trunk_at(which.impact)),
        defending(against.trunk_at(which.impact)),
        ahead(forward_of(by.spot(which.impact).heading)),
        left(left_of(by.spot(which.impact).heading)),
        towards(forward_of(against.spot(which.impact).heading)),
        defender_left(left_of(against.spot(which.impact).heading)) {}

  Vec3 base() const {
    const bool is_left = form.limb == Side::Left;
    if (is_kick(blow.attack.technique)) return joint_at(striking.pose, is_left ? left_hip : right_hip);
    return joint_at(striking.pose, is_left ? left_shoulder : right_shoulder);
  }
  Vec3 aim() const {
    return aim_at(defender, blow.aimed_at, blow.attack, highest_strike(attacker, blow.attack.technique));
  }
};

/// A target of the blow, and the hand that meets it.
struct Meeting {
  Vec3 blow = Vec3::Zero();
  Vec3 hand = Vec3::Zero();
  Side side = Side::Left;
  Vec3 elbow = Vec3::Zero();
  Vec3 sweep = Vec3::Zero();    ///< both carry on together
  Vec3 rebound = Vec3::Zero();  ///< the blow bounces off on its way back
};

/// The hand stands and the blow ends at its forearm.
/// @param share     from the elbow (0) to the fist (1)
/// @param incoming  from where the blow comes
Vec3 at_forearm(const Encounter& e, const Meeting& meeting, double share, const Vec3& incoming) {
  Pose pose = e.defending.pose;
  place_fist(e.defender.body(), meeting.side, meeting.hand, meeting.elbow, e.defending.posture.chest, pose);
  const bool is_left = meeting.side == Side::Left;
  const Vec3 elbow = joint_at(pose, is_left ? left_elbow : right_elbow),
             fist = joint_at(pose, is_left ? left_hand : right_hand);
  const Vec3 along = (fist - elbow).normalized();
  const Vec3 across = incoming - incoming.dot(along) * along;
  return elbow + share * (fist - elbow) + thickness * across.normalized();
}

Meeting parry(const Encounter& e) {
  // Against a left fist the right hand, from outside; it pushes the blow past the other shoulder.
  const Vec3 head = joint_at(e.defending.pose, Head);
  const double outside = e.form.limb == Side::Left ? -1 : 1;
  Meeting meeting{.side = e.form.limb == Side::Left ? Side::Right : Side::Left, .elbow = {0.45, -0.85, 0.1}};
  meeting.blow =
      head + stops_short(Defence::Parry) * (e.base() - head).normalized() + outside * 0.02 * e.defender_left;
  meeting.hand = meeting.blow + outside * 0.046 * e.defender_left + 0.012 * e.towards;
  meeting.sweep = -outside * 0.085 * e.defender_left - 0.02 * Vec3::UnitY();
  return meeting;
}

Meeting high_guard(const Encounter& e) {
  const Vec3 head = joint_at(e.defending.pose, Head);
  const double size = e.defender.body().height / 1.75;
  const bool hook = e.blow.attack.technique == Technique::Hook;
  const double outside = e.form.limb == Side::Left ? -1 : 1;
  Meeting meeting{.side = e.form.limb == Side::Left ? Side::Right : Side::Left, .elbow = {0.25, -0.75, 0.6}};
  if (hook) {
    meeting.hand =
        head + size * (outside * 0.115 * e.defender_left + 0.07 * e.towards + 0.10 * Vec3::UnitY());
    meeting.blow = at_forearm(e, meeting, 0.66, outside * e.defender_left + 0.5 * e.towards);
  } else {
    meeting.hand = head + size * (outside * 0.02 * e.defender_left + 0.15 * e.towards + 0.10 * Vec3::UnitY());
    meeting.blow = at_forearm(e, meeting, 0.70, e.towards);
  }
  return meeting;
}

Meeting parry_down(const Encounter& e) {
  const double size = e.defender.body().height / 1.75;
  const Vec3 belly = joint_at(e.defending.pose, LowerBack) + 0.06 * e.towards;
  Meeting meeting{.side = Side::Left, .elbow = {0.9, -0.15, -0.5}};
  meeting.blow = belly + size * 0.30 * e.towards;
  meeting.hand = meeting.blow + 0.035 * Vec3::UnitY() - 0.035 * e.defender_left - 0.02 * e.towards;
  meeting.sweep = 0.12 * e.defender_left - 0.08 * Vec3::UnitY();
  return meeting;
}

Meeting arm_check(const Encounter& e) {
  const double size = e.defender.body().height / 1.75;
  Meeting meeting{.side = Side::Left, .elbow = {0.25, -0.95, 0.15}};
  meeting.hand = joint_at(e.defending.pose, Head) +
                 size * (0.13 * e.defender_left + 0.15 * e.towards - 0.03 * Vec3::UnitY());
  meeting.blow = at_forearm(e, meeting, 0.30, e.defender_left + 0.5 * e.towards);
  meeting.rebound = 0.10 * e.defender_left + 0.05 * e.towards;
  return meeting;
}

/// Where the kick ends at the raised shin.
Vec3 at_shin(const Encounter& e) {
  const Pose pose = e.defender.pose(e.blow.impact);
  const Vec3 knee = joint_at(pose, left_knee), ankle = joint_at(pose, left_ankle);
  const Vec3 along = (ankle - knee).normalized();
  const Vec3 incoming = e.defender_left + 0.6 * e.towards;
  return knee + 0.45 * (ankle - knee) + thickness * (incoming - incoming.dot(along) * along).normalized();
}

/// Two segments and the points of them that are nearest to one another.
struct Nearest {
  Vec3 on_first = Vec3::Zero(), on_second = Vec3::Zero();
  Vec3 gap() const { return on_first - on_second; }
};

/// Alternating projection: converges fast for limbs that cross, and is exact at an end.
Nearest nearest(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto on = [](const Vec3& from, const Vec3& to, const Vec3& point) -> Vec3 {
    const Vec3 along = to - from;
    return from + std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0) * along;
  };
  Nearest found{.on_first = 0.5 * (a + b), .on_second = on(c, d, 0.5 * (a + b))};
  for (int i = 0; i < 24; ++i) {
    found.on_first = on(a, b, found.on_second);
    found.on_second = on(c, d, found.on_first);
  }
  return found;
}

/// The limb that strikes against the limb that blocks.
Nearest striking_against(const Encounter& e, Side blocking) {
  const Pose by = e.attacker.pose(e.blow.impact), against = e.defender.pose(e.blow.impact);
  const bool left = blocking == Side::Left;
  const bool shin = e.blow.attack.defence == Defence::ShinCheck;
  const Vec3 from = joint_at(against, shin ? left_knee : left ? left_elbow : right_elbow);
  const Vec3 to = joint_at(against, shin ? left_ankle : left ? left_hand : right_hand);
  const bool is_left = e.form.limb == Side::Left;
  if (!is_kick(e.blow.attack.technique))
    return nearest(joint_at(by, is_left ? left_elbow : right_elbow),
                   joint_at(by, is_left ? left_hand : right_hand), from, to);
  const Vec3 ankle = joint_at(by, is_left ? left_ankle : right_ankle);
  const Nearest shank = nearest(joint_at(by, is_left ? left_knee : right_knee), ankle, from, to);
  const Nearest foot = nearest(ankle, joint_at(by, is_left ? left_toe_tip : right_toe_tip), from, to);
  return shank.gap().norm() < foot.gap().norm() ? shank : foot;
}

/// Where a blow goes that meets nothing: to full stretch through where its target was, a swung one past it.
Vec3 through(const Encounter& e) {
  const Vec3 aim = e.aim();
  switch (e.blow.attack.technique) {
    case Technique::Hook:
      return aim - 0.16 * e.left;
    case Technique::RoundKick:
      return aim + 0.24 * e.left;
    case Technique::Jab:
    case Technique::Cross:
    case Technique::FrontKick:
      break;
  }
  return aim + 0.08 * (aim - e.base()).normalized();
}

Pulse sweep_of(const Blow& blow) {
  return {blow.impact, blow.impact + 0.10, blow.impact + 0.10, blow.released + 0.18};
}

void write_strike(const Encounter& e, const Vec3& target, const Vec3& sweep, const Vec3& rebound) {
  const Blow& blow = e.blow;
  if (is_kick(blow.attack.technique)) {
    LegMove& leg = e.attacker.leg_move(e.form.limb, blow.leg_move);
    leg.target = target;
    leg.arc = blow.attack.technique == Technique::RoundKick ? Vec3(-0.16 * e.left) : Vec3::Zero();
    const double loose = blow.released - 0.01;
    leg.swept = rebound.isZero() ? sweep_of(blow) : Pulse{loose, loose + 0.10, loose + 0.10, loose + 0.30};
    leg.sweep = rebound.isZero() ? sweep : rebound;
    return;
  }
  const bool hook = blow.attack.technique == Technique::Hook;
  e.attacker.add(e.form.limb, {.pulse = {blow.leaves, blow.impact, blow.released, blow.back},
                               .target = target,
                               .arc = hook ? Vec3(0.17 * e.left - 0.03 * e.ahead) : Vec3::Zero(),
                               .swept = sweep_of(blow),
                               .sweep = sweep,
                               .elbow = hook ? Vec3(1, 0.05, -0.35) : Vec3(0.6, -0.75, -0.2)});
}

/// Moves the end of the blow until the limbs touch: neither apart nor through one another.
void touch(const Encounter& e, Side blocking) {
  for (int i = 0; i < 5; ++i) {
    const Vec3 gap = striking_against(e, blocking).gap();
    const double distance = gap.norm();
    if (distance < 1e-6) return;
    const Vec3 correction = gap * ((thickness - distance) / distance);
    if (is_kick(e.blow.attack.technique))
      e.attacker.leg_move(e.form.limb, e.blow.leg_move).target += correction;
    else
      e.attacker.last_hand_move(e.form.limb).target += correction;
  }
}

}  // namespace

void write_contact(const Blow& blow, Fighter& attacker, Fighter& defender) {
  const Encounter e(blow, attacker, defender);
  if (!is_block(blow.attack.defence)) return write_strike(e, through(e), Vec3::Zero(), Vec3::Zero());
  if (blow.attack.defence == Defence::ShinCheck) {
    write_strike(e, at_shin(e), Vec3::Zero(), 0.08 * e.defender_left + 0.06 * e.towards);
    return touch(e, Side::Left);
  }
  const Meeting meeting = blow.attack.defence == Defence::Parry       ? parry(e)
                          : blow.attack.defence == Defence::HighGuard ? high_guard(e)
                          : blow.attack.defence == Defence::ParryDown ? parry_down(e)
                                                                      : arm_check(e);
  // Nothing stops the blow of which the guard is late; it is pulled before it hits.
  const bool in_time = blow.met <= blow.impact + 0.03;
  write_strike(e, in_time ? meeting.blow : Vec3(meeting.blow + 0.09 * e.ahead), meeting.sweep,
               meeting.rebound);
  defender.add(meeting.side, {.pulse = {blow.reacts, blow.met, blow.released + 0.04, blow.released + 0.36},
                              .target = meeting.hand,
                              .arc = Vec3::Zero(),
                              .swept = sweep_of(blow),
                              .sweep = meeting.sweep,
                              .elbow = meeting.elbow});
  if (in_time) touch(e, meeting.side);
}

}  // namespace abrazo
