#include "core/choreography/couple_holds.hpp"

#include <cmath>
#include <numbers>

#include "core/motion/joint_set.hpp"

namespace abrazo {
namespace {

Vec3 joint(const Pose& pose, int index) {
  return pose.row(index).transpose();
}
Vec3 level(const Vec3& v) {
  return {v.x(), 0, v.z()};
}

/// The space of the couple: from the leader towards the follower, and the leader's left.
struct CoupleSpace {
  Vec3 towards_follower, left, leader, follower;  ///< the last two: pelvises on the floor

  CoupleSpace(const Pose& leading, const Pose& following)
      : leader(level(joint(leading, joints::Root))), follower(level(joint(following, joints::Root))) {
    towards_follower = (follower - leader).normalized();
    left = Vec3::UnitY().cross(towards_follower);
  }
  Vec3 point(double share, double to_left, double height) const {
    return (1 - share) * leader + share * follower + to_left * left + height * Vec3::UnitY();
  }
};

/// Where an unheld hand is carried, in front of the hip.
Vec3 carried_hand(const PlacedDancer& dancer, Side side) {
  const Turn upright{.yaw = dancer.chest.yaw};
  const double h = dancer.body.height;
  return joint(dancer.pose, joints::Root) +
         upright.matrix() * Vec3(sign_of(side) * 0.13 * h, 0.055 * h, 0.135 * h);
}

}  // namespace

CoupleHolds::CoupleHolds(const std::vector<SalsaPhrase>& phrases) : shares_(0, 0.5, {}) {
  std::vector<Controls> values;
  for (const SalsaPhrase& phrase : phrases)
    for (int half_beat = 0; half_beat < 2 * beats_per_phrase; ++half_beat)
      values.push_back(controls(phrase, half_beat));
  // Averaged over three, so that a hand takes some three beats from one hold to another.
  std::vector<Controls> eased = values;
  for (std::size_t i = 1; i + 1 < values.size(); ++i)
    eased[i] = (values[i - 1] + values[i] + values[i + 1]) / 3;
  shares_ = {0, 0.5, std::move(eased)};
}

CoupleHolds::Controls CoupleHolds::controls(const SalsaPhrase& phrase, int half_beat) {
  const bool turn = phrase.move == SalsaMove::Turn, closed = phrase.move == SalsaMove::ClosedHold;
  const bool over = turn && half_beat >= 3 && half_beat <= 12;
  const bool let_go = (turn || phrase.move == SalsaMove::CrossBodyLead) && half_beat >= 1 && half_beat <= 13;
  Controls values = Controls::Zero();
  values[over ? LeftOver : closed ? LeftClosed : LeftOpen] = 1;
  values[let_go ? RightFree : closed ? RightClosed : RightOpen] = 1;
  values[Sway] = phrase.hand_sway;
  values[Height] = phrase.hand_height;
  // While she walks past him the hold goes before her.
  const bool passing = phrase.move == SalsaMove::CrossBodyLead && half_beat >= 4 && half_beat <= 13;
  values[Spread] = passing ? 0.06 : phrase.hand_spread;
  values[Grip] = phrase.grip;
  return values;
}

void CoupleHolds::place_arms(double beat, const PlacedDancer& leader, const PlacedDancer& follower) const {
  const Controls now = shares_.at(beat);
  const CoupleSpace couple(leader.pose, follower.pose);
  const double h = follower.body.height, middle = 0.5 * (h + leader.body.height);
  const double sway = now[Sway] * std::sin(std::numbers::pi / 2 * (beat + 0.4));
  const double lift = 0.3 * now[Sway] * std::sin(std::numbers::pi * beat) + now[Height];
  const double spread = now[Spread] + 0.4 * now[Sway] * std::cos(std::numbers::pi / 2 * beat);
  const Vec3 to_and_fro = sway * couple.towards_follower;

  // His left, her right. Between open and overhead the hold swings out to the side, clear of her face.
  const Vec3 left_hold =
      now[LeftOpen] * (couple.point(0.52, 0.21 + spread, 0.595 * middle + lift) + to_and_fro) +
      now[LeftClosed] * (couple.point(0.5, 0.44 + spread, 0.74 * middle + lift) + 0.6 * to_and_fro) +
      now[LeftOver] * couple.point(0.82, 0.02, 1.045 * h) +
      4 * now[LeftOver] * (1 - now[LeftOver]) * (0.07 * couple.left - 0.10 * couple.towards_follower);
  // His right, her left. On the way to her back his hand goes round her side.
  const Vec3 right_hold = couple.point(0.52, -0.21 - spread, 0.595 * middle + lift) - to_and_fro;
  const Vec3 aside = -4 * now[RightClosed] * (1 - now[RightClosed]) * 0.14 * couple.left;
  const Vec3 her_back =
      0.5 * (joint(follower.pose, joints::UpperBack) + joint(follower.pose, joints::Thorax)) +
      follower.chest.matrix() * Vec3(0.060 * h, 0, -0.047 * h);
  const Vec3 his_shoulder =
      joint(leader.pose, joints::right_shoulder) + leader.chest.matrix() * Vec3(-0.045, -0.02, 0.045);

  const Vec3 gap = 0.5 * now[Grip] * couple.towards_follower;
  const Vec3 up = now[LeftOver] * Vec3::UnitY();
  place_arm(leader.body, Side::Left,
            {left_hold - gap, now[LeftOpen] * couple.towards_follower + now[LeftClosed] * Vec3::UnitY() + up},
            leader.chest, leader.pose);
  place_arm(follower.body, Side::Right, {left_hold + gap, -now[LeftOpen] * couple.towards_follower + up},
            follower.chest, follower.pose);
  place_arm(leader.body, Side::Right,
            {now[RightOpen] * (right_hold - gap) + now[RightClosed] * her_back +
                 now[RightFree] * carried_hand(leader, Side::Right) + aside,
             now[RightOpen] * couple.towards_follower + now[RightClosed] * couple.left},
            leader.chest, leader.pose);
  place_arm(follower.body, Side::Left,
            {now[RightOpen] * (right_hold + gap) + now[RightClosed] * his_shoulder +
                 now[RightFree] * carried_hand(follower, Side::Left) + aside,
             -now[RightOpen] * couple.towards_follower},
            follower.chest, follower.pose);
}

}  // namespace abrazo
