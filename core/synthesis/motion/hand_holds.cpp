#include "core/synthesis/motion/hand_holds.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/motion/body/joint_set.hpp"
#include "core/retarget/body_retargeter.hpp"
#include "core/synthesis/motion/body_shape.hpp"
#include "core/synthesis/motion/transition.hpp"

namespace abrazo {

namespace {

constexpr double due_s = 0.4;  ///< lead time of the hand before a hold
constexpr int due_looks = 8;   ///< into that time
constexpr double ramp_s = 0.18;
constexpr double ramp_speed = 3;  ///< of a hand on its way [m/s]
constexpr double longest_ramp_s = 0.45;
constexpr double turns_round_s = 0.02;      ///< a ramp that is half way up and is to go down again
constexpr double turns_round_at_m_s2 = 40;  ///< the hand of such a ramp, at most
constexpr double reach_lost_m = 0.15;       ///< beyond the stretched arm
constexpr double reach_found_m = 0.05;
constexpr double easy_reach = 0.95;  ///< of the stretched arm; beyond it the body goes along
constexpr double draws_fully_m = 0.25, draws_least_m = 0.35;  ///< beyond easy reach
// A wrist at the shoulder: the arm points nowhere.
constexpr double near_lost_m = 0.12, near_found_m = 0.16;
constexpr double lag_rate = 30;      ///< omega [1/s]
constexpr double rests_in_s = 0.15;  ///< a released hand

constexpr double full_arm = 0.995;
constexpr double last_part_of_arm = 0.08;  ///< of it; a hold stretches it gradually
// Between the first and the second angle from the free arm to the wanted one, and below these lengths of the
// wanted one, the hand goes straight in place of turning about the shoulder.
constexpr double turns_rad = 1.2, goes_straight_rad = 2.2;
constexpr double arm_m = 0.16, no_arm_m = 0.08;
constexpr double elbow_bias_m = 0.03;    ///< an elbow hangs: where a straight arm bends
constexpr double side_relaxes_s = 0.12;  ///< of the elbow
constexpr double fastest_side = 8;       ///< [rad/s]
constexpr double least_share = 0.15;

constexpr std::array<int, 2> hands = {joints::left_hand, joints::right_hand};

bool is_due(const MotionLibrary& library, const SourcePlayhead& playhead, int user_hand, int partner_hand) {
  const double rate = pair_rate(library, playhead.pair);
  for (int look = 1; look <= due_looks; ++look) {
    const int pair =
        library.later_pair(playhead.pair, static_cast<int>(std::lround(look * due_s / due_looks * rate)));
    if (pair < 0) return false;
    if (hands_hold(library.pose(pair), {user_hand, partner_hand})) return true;
  }
  return false;
}

double bone_length_to(const Body& body, int joint) {
  return body.bone_lengths[static_cast<std::size_t>(joint - 1)];
}

double stretched_arm(const Body& body, int hand) {
  return bone_length_to(body, hand) + bone_length_to(body, hand - 1) + bone_length_to(body, hand - 2);
}

double smooth(double ramp) {
  return 1 - quintic_fade(std::clamp(ramp, 0.0, 1.0));
}

/// Of `smooth`, by its ramp.
double slope_of_smooth(double ramp) {
  return 30 * ramp * ramp * (1 - ramp) * (1 - ramp);
}

/// The reach of an arm: towards the full length it grows ever more slowly, because next to it the elbow of an
/// arm of two bones moves without bound.
double gradual_reach(double reach, double longest) {
  const double last = last_part_of_arm * longest;
  return reach <= longest - last ? reach : longest - last * std::exp((longest - last - reach) / last);
}

/// The part perpendicular to `along`, as a unit vector; `otherwise` for a straight limb.
Vec3 across(const Vec3& v, const Vec3& along, const Vec3& otherwise) {
  const auto part = [&](const Vec3& of) { return Vec3(of - of.dot(along) * along); };
  Vec3 side = part(v);
  if (side.norm() < 1e-6) side = part(otherwise);
  return side.norm() < 1e-6 ? along.unitOrthogonal() : Vec3(side.normalized());
}

}  // namespace

bool HandHolds::look_at_recording(Pair& pair, const MotionLibrary& library, const SourcePlayhead& playhead,
                                  const RecordedMoment& moment, bool source_changed, int user_hand,
                                  int partner_hand) {
  const double ends = pair.recorded && !source_changed ? hold_ends_m : hold_distance_m;
  pair.recorded = hands_apart(moment.pair, {user_hand, partner_hand}) < ends ||
                  is_due(library, playhead, user_hand, partner_hand);
  return pair.recorded;
}

/// The hand beyond the stretched arm or the wrist at the shoulder, with hysteresis.
bool HandHolds::is_out_of_reach(const Pair& pair, const Vec3& shoulder_to_hand, const Vec3& wrist_to_hand,
                                double arm_m) {
  return shoulder_to_hand.norm() > arm_m + (pair.out_of_reach ? reach_found_m : reach_lost_m) ||
         (shoulder_to_hand - wrist_to_hand).norm() < (pair.out_of_reach ? near_found_m : near_lost_m);
}

/// The recorded offset; the difference from that of another source or of a released hand fades.
void HandHolds::follow(Pair& pair, const Vec3& offset, bool begins, double elapsed_s) {
  if (begins) {
    pair.lag = pair.ramp > 0 ? Vec3(pair.offset - offset) : Vec3::Zero();
    pair.lag_speed.setZero();
  } else {
    const Vec3 slope = pair.lag_speed + lag_rate * pair.lag;
    const double shrink = std::exp(-lag_rate * elapsed_s);
    pair.lag = shrink * (pair.lag + elapsed_s * slope);
    pair.lag_speed = shrink * (pair.lag_speed - lag_rate * elapsed_s * slope);
  }
  pair.offset = offset + pair.lag;
}

void HandHolds::update(const Surroundings& now, double elapsed_s) {
  const Eigen::Matrix3d heading = now.user_root.rotation(), own = now.place.rotation();
  const Vec3 stands(now.place.position.x(), 0, now.place.position.z());
  for (std::size_t side = 0; side < hands.size(); ++side)
    user_hands_[side].follow(now.user.row(hands[side]), elapsed_s);
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    Pair& pair = pairs_[p];
    const int user_hand = hands[p / 2], partner_hand = hands[p % 2];
    const Vec3 at_user = user_hands_[p / 2].at;
    const bool was_held = pair.recorded && !pair.out_of_reach;
    const bool is_recorded = look_at_recording(pair, now.library, now.playhead, now.moment,
                                               now.source_changed, user_hand, partner_hand);
    const Vec3 offset =
        (now.moment.pair.row(partner_hand + joint_count) - now.moment.pair.row(user_hand)).transpose();
    const Vec3 shoulder = now.partner.row(partner_hand - 3);
    const Vec3 wrist_to_hand = now.partner.row(partner_hand) - now.partner.row(partner_hand - 1);
    pair.out_of_reach = is_out_of_reach(pair, at_user + heading * offset - shoulder, wrist_to_hand,
                                        stretched_arm(now.body, partner_hand));
    const bool is_held = is_recorded && !pair.out_of_reach;
    if (is_held) {
      follow(pair, offset, !was_held || now.source_changed, elapsed_s);
      const Vec3 asked = own.transpose() * (at_user + heading * pair.offset - stands);
      pair.asked_speed = was_held && elapsed_s > 0 ? Vec3((asked - pair.asked) / elapsed_s) : Vec3::Zero();
      pair.asked = asked;
    } else {
      pair.asked += elapsed_s * pair.asked_speed;
      pair.asked_speed *= std::exp(-elapsed_s / rests_in_s);
      pair.offset = heading.transpose() * (stands + own * pair.asked - at_user);
    }
    const double way = (at_user + heading * pair.offset - Vec3(now.partner.row(partner_hand))).norm();
    const double pace = 1 / std::clamp(ramp_s + way / ramp_speed, ramp_s, longest_ramp_s);
    const double wanted =
        ((is_held ? pace : -pace) - pair.ramp_pace) * (1 - std::exp(-elapsed_s / turns_round_s));
    const double most = turns_round_at_m_s2 * elapsed_s / std::max(way * slope_of_smooth(pair.ramp), 1e-3);
    pair.ramp_pace += std::clamp(wanted, -most, most);
    pair.ramp += pair.ramp_pace * elapsed_s;
    if (pair.ramp <= 0 || pair.ramp >= 1) {
      pair.ramp = std::clamp(pair.ramp, 0.0, 1.0);
      pair.ramp_pace = 0;
    }
  }
}

void HandHolds::place_arms(Pose& partner, const Surroundings& now, double elapsed_s) {
  const Eigen::Matrix3d heading = now.user_root.rotation();
  for (std::size_t partner_side = 0; partner_side < hands.size(); ++partner_side) {
    Vec3 sum = Vec3::Zero();
    double weights = 0, most = 0;
    for (std::size_t user_side = 0; user_side < hands.size(); ++user_side) {
      const Pair& pair = pairs_[2 * user_side + partner_side];
      const double weight = smooth(pair.ramp);
      sum += weight * (user_hands_[user_side].at + heading * pair.offset);
      weights += weight;
      most = std::max(most, weight);
    }
    Arm& arm = arms_[partner_side];
    if (weights > 0)
      reach_for(partner, now.body, now.place, hands[partner_side], sum / weights, most, arm, elapsed_s);
    else
      arm.reaches = false;
  }
}

/// Turns the arm about the shoulder and stretches it so that the hand, which keeps its direction, moves by
/// `share` of the way to `target`.
void HandHolds::reach_for(Pose& pose, const Body& body, const RootFrame& place, int hand, const Vec3& target,
                          double share, Arm& arm, double elapsed_s) {
  const int wrist = hand - 1, elbow = hand - 2, shoulder = hand - 3;
  const Vec3 from = pose.row(shoulder);
  const Vec3 to_hand = pose.row(hand) - pose.row(wrist);
  const Vec3 now = Vec3(pose.row(wrist)) - from;
  const Vec3 wanted = target - to_hand - from;
  const double reach_now = now.norm(), reach_wanted = wanted.norm();
  if (reach_now < 1e-6 || reach_wanted < 1e-6) return;
  const double longest = full_arm * (bone_length_to(body, elbow) + bone_length_to(body, wrist));
  const Vec3 whole_turn = turn_between(now / reach_now, wanted / reach_wanted);
  Vec3 turn = share * whole_turn;
  Vec3 along = turned(now / reach_now, turn);
  double reach = reach_now + share * (reach_wanted - reach_now);
  // The axis of a half turn, and the direction of a hand at the shoulder, are undefined, and next to them a
  // small motion of the target swings the arm.
  const double straight = std::max(smooth((whole_turn.norm() - turns_rad) / (goes_straight_rad - turns_rad)),
                                   smooth((arm_m - reach_wanted) / (arm_m - no_arm_m)));
  if (straight > 0) {
    const Vec3 point = now + share * (wanted - now);
    const Vec3 mixed = (1 - straight) * reach * along + straight * point;
    reach = mixed.norm();
    if (reach < 1e-6) return;
    along = mixed / reach;
    turn = turn_between(now / reach_now, along);
  }
  reach += share * (gradual_reach(reach, longest) - reach);
  reach = std::min(reach, std::max(longest, (1 - share) * reach_now));

  // The elbow's side is carried along with the arm, and goes to that of the free arm bit by bit.
  const Eigen::Matrix3d heading = place.rotation();
  const Vec3 down = -Vec3::UnitY();
  const Vec3 free_side =
      across(turned(Vec3(pose.row(elbow)) - from + elbow_bias_m * down, turn), along, down);
  Vec3 side = free_side;
  if (arm.reaches) {
    const Vec3 along_before = heading * arm.along;
    side = across(turned(heading * arm.side, turn_between(along_before, along)), along, down);
    const double off = std::atan2(along.dot(side.cross(free_side)), side.dot(free_side));
    const double held = std::max(share, least_share);
    const double relaxed = off * (1 - std::exp(-elapsed_s / (side_relaxes_s * held)));
    const double most = fastest_side * elapsed_s / held;
    side = turned(side, std::clamp(relaxed, -most, most) * along);
  }
  arm = {true, heading.transpose() * along, heading.transpose() * side};
  Vec3 end = from + reach * along;
  pose.row(elbow) =
      two_bone_joint(from, end, bone_length_to(body, elbow), bone_length_to(body, wrist), from + side)
          .transpose();
  pose.row(wrist) = end.transpose();
  pose.row(hand) = (end + to_hand).transpose();
}

Vec3 HandHolds::drawn(const Pose& partner, const RecordedMoment& moment, const Pose& user,
                      const RootFrame& user_root, const Body& body) const {
  const Eigen::Matrix3d heading = user_root.rotation();
  Vec3 most = Vec3::Zero();
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    if (!pairs_[p].recorded) continue;
    const int user_hand = hands[p / 2], partner_hand = hands[p % 2];
    const Vec3 offset =
        (moment.pair.row(partner_hand + joint_count) - moment.pair.row(user_hand)).transpose();
    const Vec3 to_hand = Vec3(user.row(user_hand)) + heading * offset - Vec3(partner.row(partner_hand - 3));
    const double apart = to_hand.norm(), excess = apart - easy_reach * stretched_arm(body, partner_hand);
    if (excess <= 0) continue;
    const double share = std::clamp((draws_least_m - excess) / (draws_least_m - draws_fully_m), 0.0, 1.0);
    const Vec3 drawn = share * excess / apart * to_hand;
    if (drawn.squaredNorm() > most.squaredNorm()) most = drawn;
  }
  most.y() = 0;
  return most;
}

void HandHolds::list(const Pose& partner, const Pose& user, const RootFrame& user_root,
                     std::vector<HandHold>& holds) const {
  holds.clear();
  const Eigen::Matrix3d heading = user_root.rotation();
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    if (pairs_[p].ramp <= 0) continue;
    const double strength = smooth(pairs_[p].ramp);
    const Vec3 at_user = user.row(hands[p / 2]);
    const Vec3 reached = Vec3(partner.row(hands[p % 2])) - at_user;
    const Vec3 asked = user_hands_[p / 2].at + heading * pairs_[p].offset - at_user;
    holds.push_back({p / 2 == 0, p % 2 == 0, strength, reached + strength * (asked - reached)});
  }
}

}  // namespace abrazo
