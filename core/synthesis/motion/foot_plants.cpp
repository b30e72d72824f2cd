#include "core/synthesis/motion/foot_plants.hpp"

#include <algorithm>
#include <cmath>

#include "core/motion/body/joint_set.hpp"
#include "core/retarget/body_retargeter.hpp"
#include "core/synthesis/motion/body_shape.hpp"
#include "core/synthesis/motion/transition.hpp"

namespace abrazo {

namespace {

// In the recording.
constexpr double standing_height_m = 0.035;
constexpr double standing_speed = 0.5;
constexpr double shortest_stand_s = 4.0 / 60;

// As it is shown.
constexpr double plant_height_m = 0.06;
constexpr double plant_speed = 3.0;
constexpr double slip_dies_s = 0.03;
constexpr double farthest_off_m = 0.25;
constexpr double longest_leg = 1.03;
constexpr double soft_reach = 0.985;
constexpr double shortest_fade_s = 0.12, longest_fade_s = 0.5;
/// A straight leg bends forward; one with its knee `bent_knee_m` off the line keeps its direction.
constexpr double knee_bias_m = 0.05, bent_knee_m = 0.08;
constexpr double pressed_share = 0.3;  ///< of its recorded height over rest that a planted toe base keeps
constexpr double stepping_s = 0.4, step_height_m = 0.06;
// Omega of the springs that press a standing foot down and lift one that leaves [1/s].
constexpr double press_rate = 50, lift_rate = 24;
// A foot that the recording lifts is released when it is off the floor, or after these at the latest.
constexpr double lifted_m = 0.02, longest_lift_s = 0.12, farthest_lift_m = 0.15;
// A foot in the air anticipates the body's way beside the recording: by this share of the remaining way.
constexpr double lead_share = 0.4, lead_rate = 12;  // omega [1/s]
constexpr double clearance_m = 0.06;  ///< a foot in the air is at least so high, if the recorded one is

Vec3 horizontal(const Vec3& v) {
  return {v.x(), 0, v.z()};
}

Vec3 partner_joint_in_take(const MotionLibrary& library, int pair, int joint) {
  const RootFrame& root = library.root(pair);
  return root.rotation() * Vec3(library.pose(pair).row(joint + joint_count)) + root.position;
}

bool is_low_and_slow(const MotionLibrary& library, int pair, int toe_base) {
  const double rest = library.passive_body(pair).body.toe_rest_height;
  const double height = library.root(pair).position.y() + library.pose(pair)(toe_base + joint_count, 1);
  if (height >= rest + standing_height_m) return false;
  int other = library.later_pair(pair, 1);
  if (other < 0) other = library.later_pair(pair, -1);
  if (other < 0) return true;
  const Vec3 path =
      partner_joint_in_take(library, other, toe_base) - partner_joint_in_take(library, pair, toe_base);
  return path.norm() * pair_rate(library, pair) < standing_speed;
}

/// x'' = -omega^2 (x - wanted) - 2 omega x', exactly.
template <typename Value>
void follow_critically(Value& value, Value& speed, const Value& wanted, double omega, double elapsed_s) {
  const Value off = value - wanted;
  const Value slope = speed + omega * off;
  const double shrink = std::exp(-omega * elapsed_s);
  value = wanted + shrink * (off + elapsed_s * slope);
  speed = shrink * (speed - omega * elapsed_s * slope);
}

/// Low and slow frames around one, with short gaps closed.
class StandingRun {
 public:
  StandingRun(const MotionLibrary& library, int pair, int toe_base)
      : library_(library),
        pair_(pair),
        toe_base_(toe_base),
        shortest_(std::clamp(static_cast<int>(std::lround(shortest_stand_s * pair_rate(library, pair))), 1,
                             most_frames)) {}

  bool stands() const {
    if (!is_closed(0)) return false;
    int length = 1;
    for (const int direction : {-1, 1})
      for (int step = 1; step < shortest_ && length < shortest_ && is_closed(direction * step); ++step)
        ++length;
    return length >= shortest_;
  }

 private:
  static constexpr int most_frames = 16;

  bool is_raw(int step) const {
    const int pair = library_.later_pair(pair_, step);
    return pair >= 0 && is_low_and_slow(library_, pair, toe_base_);
  }
  bool is_closed(int step) const {
    if (is_raw(step)) return true;
    for (int before = 1; before < shortest_; ++before)
      if (is_raw(step - before)) {
        for (int after = 1; before + after <= shortest_; ++after)
          if (is_raw(step + after)) return true;
        return false;
      }
    return false;
  }

  const MotionLibrary& library_;
  int pair_, toe_base_, shortest_;
};

bool stands_at(const MotionLibrary& library, int pair, bool left) {
  return StandingRun(library, pair, left ? joints::left_toe_base : joints::right_toe_base).stands();
}

}  // namespace

bool stands_in_recording(const MotionLibrary& library, const SourcePlayhead& playhead, bool left) {
  return stands_at(library, nearest_pair(library, playhead), left);
}

double stands_again_in_s(const MotionLibrary& library, const SourcePlayhead& playhead, bool left,
                         double most_s) {
  const double rate = pair_rate(library, playhead.pair);
  const int most = static_cast<int>(std::ceil(most_s * rate));
  const int from = nearest_pair(library, playhead);
  const int toe_base = left ? joints::left_toe_base : joints::right_toe_base;
  for (int step = 1; step <= most; ++step) {
    const int pair = library.later_pair(from, step);
    if (pair < 0) break;
    if (is_low_and_slow(library, pair, toe_base)) return step / rate;
  }
  return most_s;
}

void FootPlants::let_go(Foot& foot, const FootMoment& now, double elapsed_s, double fades_s) {
  foot.planted = false;
  foot.offset = horizontal(foot.anchor - now.free);
  foot.rate = elapsed_s > 0 ? Vec3(foot.slip - horizontal(now.free - foot.free) / elapsed_s) : Vec3::Zero();
  foot.since_s = 0;
  foot.fades_s = fades_s;
}

void FootPlants::settle(int at, const Vec3& reached) {
  Foot& foot = feet_[static_cast<std::size_t>(at)];
  foot.shown = reached;
  if (foot.planted) foot.anchor = horizontal(reached);
}

void FootPlants::let_go(int at, const Vec3& shown) {
  Foot& foot = feet_[static_cast<std::size_t>(at)];
  foot.planted = false;
  foot.waits_for_lift = true;
  foot.offset = horizontal(shown - foot.free);
  foot.rate.setZero();
  foot.since_s = 0;
  foot.fades_s = stepping_s;
  foot.shown = shown;
}

bool FootPlants::must_step(const Foot& foot, const FootMoment& now) const {
  for (const Foot& other : feet_)
    if (other.steps) return false;
  const Vec3 off = horizontal(foot.anchor - now.free);
  return off.norm() > farthest_off_m || (now.ankle + off - now.hip).norm() > longest_leg * now.leg_length;
}

void FootPlants::stay(Foot& foot, const FootMoment& now, double elapsed_s) const {
  const double left = std::exp(-elapsed_s / slip_dies_s);
  foot.anchor += slip_dies_s * (1 - left) * foot.slip;
  foot.slip *= left;
  if (now.lands) foot.since_s = 0;
  const bool is_off_floor = foot.shown.y() > now.rest_height + lifted_m;
  const bool is_late =
      foot.since_s > longest_lift_s || horizontal(foot.anchor - now.free).norm() > farthest_lift_m;
  if (!now.lands && (is_off_floor || is_late)) {
    let_go(foot, now, elapsed_s, std::clamp(now.lands_in_s, shortest_fade_s, longest_fade_s));
  } else if (must_step(foot, now)) {
    let_go(foot, now, elapsed_s, stepping_s);
    foot.steps = true;
  }
}

/// Position of a released foot, and its lift during a step.
FootPlants::OnItsWay FootPlants::go(Foot& foot, const FootMoment& now) {
  const double share = foot.fades_s > 0 ? foot.since_s / foot.fades_s : 1;
  if (share >= 1) {
    foot.steps = false;
    return {now.free + foot.lead, 0};
  }
  const Vec3 left = (1 - quintic_fade(share)) * foot.lead + quintic_fade(share) * foot.offset +
                    foot.fades_s * quintic_slope(share) * foot.rate;
  return {now.free + left, foot.steps ? step_height_m * 64 * std::pow(share * (1 - share), 3) : 0};
}

void FootPlants::land(Foot& foot, const FootMoment& now, const Vec3& at, double elapsed_s) {
  if (!now.lands || foot.waits_for_lift || foot.steps) return;
  const Vec3 speed =
      foot.is_known && elapsed_s > 0 ? Vec3(horizontal(at - foot.shown) / elapsed_s) : Vec3::Zero();
  if (now.free.y() >= now.rest_height + plant_height_m || speed.norm() >= plant_speed ||
      horizontal(at - now.free).norm() >= farthest_off_m)
    return;
  foot.planted = true;
  foot.anchor = horizontal(at);
  foot.slip = speed;
}

/// A body that is drawn to a place goes there by steps that lead: feet that land under it trail behind.
void FootPlants::aim(Foot& foot, const FootMoment& now, double elapsed_s) {
  const Vec3 wanted = lead_share * horizontal(now.body_goes);
  follow_critically(foot.lead, foot.lead_speed, wanted, lead_rate, elapsed_s);
}

/// A standing foot is pressed to the floor, one that leaves it is quick to be clear of it.
void FootPlants::raise(Foot& foot, const FootMoment& now, double elapsed_s) {
  const double over_rest = now.recorded_height - now.rest_height;
  double wanted = 0;
  if (foot.planted && now.lands)
    wanted = now.rest_height + std::min(over_rest, pressed_share * over_rest) - now.free.y();
  else if (!now.lands)
    wanted = std::max(0.0, now.rest_height + std::min(over_rest, clearance_m) - now.free.y());
  const double rate = foot.planted && now.lands ? press_rate : lift_rate;
  follow_critically(foot.lift, foot.lift_speed, wanted, rate, elapsed_s);
}

std::array<Vec3, 2> FootPlants::update(const std::array<FootMoment, 2>& moments, double elapsed_s) {
  std::array<Vec3, 2> shown;
  for (std::size_t f = 0; f < feet_.size(); ++f) {
    Foot& foot = feet_[f];
    const FootMoment& now = moments[f];
    foot.since_s += elapsed_s;
    if (!now.lands) foot.waits_for_lift = false;
    aim(foot, now, elapsed_s);
    if (foot.planted) stay(foot, now, elapsed_s);
    OnItsWay way{now.free, 0};
    if (!foot.planted) {
      way = go(foot, now);
      land(foot, now, way.at, elapsed_s);
    }
    if (foot.planted) way.at = {foot.anchor.x(), way.at.y(), foot.anchor.z()};
    raise(foot, now, elapsed_s);
    way.at.y() += foot.lift + way.step_lift;
    foot.free = now.free;
    foot.shown = way.at;
    foot.is_known = true;
    shown[f] = way.at;
  }
  return shown;
}

void place_foot(Pose& pose, const Body& body, bool left, const Vec3& toe_base, const Vec3& forward) {
  using namespace joints;
  const int hip_joint = left ? left_hip : right_hip;
  const int knee = hip_joint + 1, ankle = hip_joint + 2, toes = hip_joint + 3, tip = hip_joint + 4;
  const auto length = [&](int joint) { return body.bone_lengths[static_cast<std::size_t>(joint - 1)]; };
  const Vec3 hip = pose.row(hip_joint);
  const Vec3 foot_up = pose.row(ankle) - pose.row(toes);
  const Vec3 toe_tip = pose.row(tip) - pose.row(toes);
  const Vec3 free_leg = Vec3(pose.row(ankle)) - hip;
  const Vec3 free_knee = Vec3(pose.row(knee)) - hip;
  // A leg may be as straight as before, and stretches further like a spring, because a locking knee jerks.
  const double free_reach = free_leg.norm();
  const double room = soft_reach * (length(knee) + length(ankle)) - free_reach;
  const double beyond = (toe_base + foot_up - hip).norm() - free_reach;
  double reach = free_reach + beyond;
  if (beyond > 0) reach = free_reach + (room > 0 ? room * (1 - std::exp(-beyond / room)) : 0);
  Vec3 to_ankle = foot_up;
  if (beyond > 0) {
    const Vec3 towards_hip = (hip - toe_base).normalized();
    const Vec3 turn = turn_between(foot_up.normalized(), towards_hip);
    double least = 0, most = 1;     // share of the turn
    for (int n = 0; n < 48; ++n) {  // to the last bit: a coarser share would jump with rounding
      const double middle = 0.5 * (least + most);
      ((toe_base + turned(foot_up, middle * turn) - hip).norm() > reach ? least : most) = middle;
    }
    to_ankle = turned(foot_up, most * turn);
  }
  Vec3 end = toe_base + to_ankle;
  // The knee is carried along with the leg; that of a straight leg goes forward.
  const Vec3 along = free_leg.normalized();
  const Vec3 turn = turn_between(along, (end - hip).normalized());
  const Vec3 side = free_knee - free_knee.dot(along) * along;
  const double straight = std::max(0.0, 1 - side.norm() / bent_knee_m);
  const Vec3 hint = hip + turned(free_knee, turn) + knee_bias_m * straight * straight * forward;
  pose.row(knee) = two_bone_joint(hip, end, length(knee), length(ankle), hint).transpose();
  pose.row(ankle) = end.transpose();
  pose.row(toes) = (end - to_ankle).transpose();
  pose.row(tip) = (end - to_ankle + toe_tip).transpose();
}

}  // namespace abrazo
