#include "core/choreography/couple_holds.hpp"

#include <cmath>
#include <numbers>

#include "core/base/positions.hpp"
#include "core/choreography/limb_ik.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {
namespace {

int shoulder(Side side) {
  return side == Side::Left ? joints::left_shoulder : joints::right_shoulder;
}

/// A place beside the dancer's own trunk, in shares of the body height: to the hand's side, above the root,
/// forward.
Vec3 beside(const PlacedDancer& dancer, Side side, const Vec3& share) {
  const Turn upright{.yaw = dancer.chest.yaw};
  return joint_at(dancer.pose, joints::Root) +
         dancer.body.height * (upright.matrix() * Vec3(sign_of(side) * share.x(), share.y(), share.z()));
}
/// Where an unheld hand is carried: it goes round with the steps.
Vec3 carried_hand(const PlacedDancer& dancer, Side side, double beat) {
  const double phase = std::numbers::pi * (beat + (side == Side::Left ? 0.3 : 1.1));
  return beside(
      dancer, side,
      {0.19 + 0.03 * std::cos(phase), 0.07 + 0.04 * std::cos(0.5 * phase), 0.15 + 0.04 * std::sin(phase)});
}
/// Where a hand likes to be that holds another's.
Vec3 held_hand(const PlacedDancer& dancer, Side side) {
  return beside(dancer, side, {0.12, 0.055, 0.22});
}

/// Moved out of the dancer's trunk and head, without a kink: the nearer to the axis, the farther.
/// @param share share of the way out completed
Vec3 clear_of(const PlacedDancer& dancer, const Vec3& point, double share) {
  const Vec3 head = joint_at(dancer.pose, joints::Head), root = joint_at(dancer.pose, joints::Root);
  const double up = (point.y() - root.y()) / (head.y() - root.y());
  const Vec3 axis = along_floor(root + std::clamp(up, 0.0, 1.0) * (head - root));
  const double fade = 1 - minimum_jerk((up - 1.05) / 0.3);
  const Vec3 away = along_floor(point) - axis;
  const double distance = away.norm(), radius = 0.15 * fade * share;
  if (distance < 1e-6) return point;
  return point + away * (std::hypot(distance, radius) / distance - 1);
}

/// Not behind the dancer's own shoulder, where no arm likes to go; without a kink.
/// @param share share of the way to the front completed
Vec3 in_front_of(const PlacedDancer& dancer, Side side, const Vec3& point, double share) {
  const Vec3 forward = dancer.chest.matrix() * Vec3::UnitZ();
  const double ahead = (point - joint_at(dancer.pose, shoulder(side))).dot(forward);
  return point + share * 0.5 * (std::hypot(ahead, 0.08) - ahead) * forward;
}

struct Grasp {
  const PlacedDancer& dancer;
  Side side;
};

/// The place nearest to `wanted` that both arms reach with elbows bent and that is in neither body.
/// @param raised  share of a hold above the heads, which may be behind a shoulder
Vec3 meeting_place(const Grasp& one, const Grasp& two, Vec3 wanted, double raised = 0) {
  for (int i = 0; i < 6; ++i)
    for (const Grasp* grasp : {&one, &two}) {
      const DancerBody& body = grasp->dancer.body;
      const double arm = body.upper_arm + body.forearm + body.hand;
      const Vec3 base = joint_at(grasp->dancer.pose, shoulder(grasp->side));
      // Softly from some 91 % of the arm on, so that nothing is left to the wrist's own limit.
      wanted = within_reach(base, wanted, 0.985 * arm);
      if (i < 3) wanted = clear_of(grasp->dancer, wanted, 1 - raised);
      wanted = in_front_of(grasp->dancer, grasp->side, wanted, 1 - raised);
    }
  return wanted;
}

}  // namespace

CoupleHolds::CoupleHolds(const std::vector<SalsaPhrase>& phrases) : shares_(0, 0.5, {}) {
  std::vector<Controls> values;
  for (const SalsaPhrase& phrase : phrases)
    for (int half_beat = 0; half_beat < 2 * beats_per_phrase; ++half_beat)
      values.push_back(controls(phrase, half_beat));
  // Averaged over three, so that a hand takes some two beats from one hold to another.
  std::vector<Controls> eased = values;
  for (std::size_t i = 1; i + 1 < values.size(); ++i)
    eased[i] = (values[i - 1] + values[i] + values[i + 1]) / 3;
  shares_ = {0, 0.5, std::move(eased)};
}

CoupleHolds::Channel CoupleHolds::left_hold(const SalsaPhrase& phrase, int half_beat) {
  using enum SalsaFigure;
  const auto from_to = [half_beat](int first, int last) { return half_beat >= first && half_beat <= last; };
  switch (phrase.figure) {
    case ClosedBasic:
      return LeftClosed;
    case FollowerRightTurn:
    case FollowerLeftTurn:
    case InsideTurn:
      return from_to(4, 13) ? LeftOverHer : LeftOpen;
    case LeaderRightTurn:
    case LeaderLeftTurn:
      return from_to(4, 13) ? LeftOverHim : LeftOpen;
    case InAndOut:
      return from_to(2, 11) ? LeftFree : LeftOpen;
    case WalkToHisLeft:
      return from_to(1, 13) ? LeftFree : LeftOpen;
    case WalkInTandem:
      return from_to(3, 11) ? LeftTandem : from_to(1, 13) ? LeftFree : LeftOpen;
    default:
      return LeftOpen;
  }
}

CoupleHolds::Channel CoupleHolds::right_hold(const SalsaPhrase& phrase, int half_beat) {
  using enum SalsaFigure;
  const auto from_to = [half_beat](int first, int last) { return half_beat >= first && half_beat <= last; };
  switch (phrase.figure) {
    case OpenBasic:
      return phrase.both_hands ? RightOpen : RightFree;
    case ClosedBasic:
      return RightClosed;
    case CrossBodyLead:
      return phrase.both_hands || !from_to(1, 13) ? RightOpen : RightFree;
    case WalkToHisLeft:
      return RightOpen;
    case WalkInTandem:
      return from_to(3, 11) ? RightTandem : RightFree;
    case InAndOut:
      return from_to(4, 11) ? RightWaist : RightFree;
    default:
      return from_to(1, 13) ? RightFree : RightOpen;
  }
}

CoupleHolds::Controls CoupleHolds::controls(const SalsaPhrase& phrase, int half_beat) {
  Controls values = Controls::Zero();
  values[left_hold(phrase, half_beat)] = 1;
  values[right_hold(phrase, half_beat)] = 1;
  values[Sway] = phrase.hand_sway;
  values[Height] = phrase.hand_height;
  values[Spread] = phrase.hand_spread;
  values[Grip] = phrase.grip;
  return values;
}

CoupleHolds::Holds CoupleHolds::holds_at(double beat, const Controls& now, const PlacedDancer& leader,
                                         const PlacedDancer& follower) {
  const Vec3 his_root = along_floor(joint_at(leader.pose, joints::Root)),
             her_root = along_floor(joint_at(follower.pose, joints::Root));
  const Vec3 her_head = along_floor(joint_at(follower.pose, joints::Head)),
             his_head = along_floor(joint_at(leader.pose, joints::Head));
  Holds holds;
  holds.ahead = (her_root - his_root).normalized();
  const Vec3 left = Vec3::UnitY().cross(holds.ahead);
  const double h = follower.body.height, middle = 0.5 * (h + leader.body.height);
  // Standing close leaves the hands little room to be drawn to and fro.
  const double room = now[Sway] * minimum_jerk(((her_root - his_root).norm() - 0.25) / 0.55);
  const Vec3 to_and_fro = room * std::sin(std::numbers::pi / 2 * (beat + 0.4)) * holds.ahead;
  const Vec3 lift = (0.5 * now[Sway] * std::sin(std::numbers::pi * beat) + now[Height]) * Vec3::UnitY();
  const double spread = now[Spread] + 0.4 * now[Sway] * std::cos(std::numbers::pi / 2 * beat);
  const auto half_way = [&](Side his, Side hers) -> Vec3 {
    return 0.5 * (held_hand(leader, his) + held_hand(follower, hers));
  };
  // His left, her right. Between open and overhead the hold swings out to the side, clear of the faces.
  const double over = now[LeftOverHer] + now[LeftOverHim];
  const Vec3 open = half_way(Side::Left, Side::Right) + spread * left + lift + to_and_fro;
  const Vec3 closed = 0.5 * (his_root + her_root) + (0.44 + spread) * left + 0.74 * middle * Vec3::UnitY() +
                      lift + 0.6 * to_and_fro;
  const Vec3 over_her = her_head - 0.05 * holds.ahead + 1.05 * h * Vec3::UnitY();
  const Vec3 over_him = his_head + 0.12 * holds.ahead + 1.05 * leader.body.height * Vec3::UnitY();
  const Vec3 aside =
      4 * over * (1 - over) * (0.09 * left + (now[LeftOverHim] - now[LeftOverHer]) * 0.10 * holds.ahead);
  const Vec3 wanted = (1 - now[LeftClosed] - over) * open + now[LeftClosed] * closed +
                      now[LeftOverHer] * over_her + now[LeftOverHim] * over_him + aside;
  holds.left = meeting_place({leader, Side::Left}, {follower, Side::Right}, wanted, over);
  // His right, her left.
  holds.right = meeting_place({leader, Side::Right}, {follower, Side::Left},
                              half_way(Side::Right, Side::Left) - spread * left + lift - to_and_fro);
  // In tandem it is both right hands, at her right side.
  holds.tandem = meeting_place({leader, Side::Right}, {follower, Side::Right},
                               0.7 * beside(leader, Side::Right, {0.21, 0.13, 0.24}) +
                                   0.3 * beside(follower, Side::Right, {0.22, 0.14, 0.12}));
  return holds;
}

void CoupleHolds::place_arms(double beat, const PlacedDancer& leader, const PlacedDancer& follower) const {
  const Controls now = shares_.at(beat);
  const Holds holds = holds_at(beat, now, leader, follower);
  const double h = follower.body.height;
  const Vec3 left = Vec3::UnitY().cross(holds.ahead);
  // On the way to her back his hand passes around her side.
  const Vec3 aside = -4 * now[RightClosed] * (1 - now[RightClosed]) * 0.14 * left;
  const auto hers = [&](int index) { return joint_at(follower.pose, index); };
  const Vec3 her_back = 0.35 * hers(joints::UpperBack) + 0.65 * hers(joints::Thorax) +
                        follower.chest.matrix() * Vec3(0.070 * h, 0, -0.035 * h);
  const Vec3 her_waist = 0.5 * (hers(joints::LowerBack) + hers(joints::UpperBack)) +
                         follower.chest.matrix() * Vec3(0.02 * h, 0, -0.07 * h);
  const Vec3 his_shoulder =
      joint_at(leader.pose, joints::right_shoulder) + leader.chest.matrix() * Vec3(-0.045, -0.02, 0.045);

  const double over = now[LeftOverHer] + now[LeftOverHim];
  const auto place = [over](const PlacedDancer& dancer, Side side, const Vec3& hand, const Vec3& pointing) {
    const Vec3 easy = in_front_of(dancer, side, hand, 1 - over);
    place_arm(dancer.body, side, {easy, pointing}, dancer.chest, dancer.pose);
  };
  const Vec3 gap = 0.5 * now[Grip] * holds.ahead, up = (over + now[LeftClosed]) * Vec3::UnitY();
  const double left_held = 1 - now[LeftFree] - now[LeftTandem], right_held = now[RightOpen];
  // Hands that hold one another stray together.
  const Vec3 left_stray = 0.5 * left_held * (leader.left_stray + follower.right_stray),
             right_stray = 0.5 * right_held * (leader.right_stray + follower.left_stray);
  place(leader, Side::Left,
        left_held * (holds.left - gap) + left_stray +
            (1 - left_held) * (carried_hand(leader, Side::Left, beat) + leader.left_stray),
        now[LeftOpen] * holds.ahead + up);
  place(follower, Side::Right,
        left_held * (holds.left + gap) + left_stray +
            now[LeftFree] * carried_hand(follower, Side::Right, beat) +
            now[LeftTandem] * (holds.tandem + gap) + (1 - left_held) * follower.right_stray,
        -now[LeftOpen] * holds.ahead + over * Vec3::UnitY());
  place(leader, Side::Right,
        right_held * (holds.right - gap) + right_stray + aside + now[RightClosed] * her_back +
            now[RightWaist] * her_waist + now[RightFree] * carried_hand(leader, Side::Right, beat) +
            now[RightTandem] * (holds.tandem - gap) + (1 - right_held) * leader.right_stray,
        right_held * holds.ahead + now[RightClosed] * left);
  const double left_free = now[RightFree] + now[RightWaist] + now[RightTandem];
  place(follower, Side::Left,
        right_held * (holds.right + gap) + right_stray + aside + now[RightClosed] * his_shoulder +
            left_free * carried_hand(follower, Side::Left, beat) + (1 - right_held) * follower.left_stray,
        -right_held * holds.ahead);
}

}  // namespace abrazo
