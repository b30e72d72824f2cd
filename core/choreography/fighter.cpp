#include "core/choreography/fighter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/base/positions.hpp"
#include "core/base/units.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {
namespace {

using namespace joints;

constexpr double idle_spacing = 0.45;     ///< [s]
constexpr double lowered_spacing = 0.02;  ///< [s]
constexpr double longest_leg = 0.975;     ///< of a standing leg, of its length
constexpr double guard_leg = 0.945;
constexpr double longest_step = 0.29;   ///< of the height
constexpr double shortest_step = 0.24;  ///< [s]

enum IdleChannel { SwayForward, SwayLeft, IdleLean, IdleTilt, IdleYaw, IdleHead, LeftHandX, RightHandX = 9 };

Vec3 blend(const Vec3& from, const Vec3& to, double share) {
  return from + share * (to - from);
}
/// Largest at half a share of 0 .. 1, with no edge at either end.
double arm_swing(double share) {
  return 4 * share * (1 - share);
}

/// A lean in the space of the spot as a segment that is turned by `yaw` from it has it.
Turn leaning(double heading, double yaw, double lean, double tilt) {
  const double c = std::cos(yaw), s = std::sin(yaw);
  return {.yaw = heading + yaw, .pitch = c * lean + s * tilt, .roll = s * lean - c * tilt};
}

/// Drift of rms 1 and twelve channels; knots are drawn, the spline between them has about 0.6 of their rms.
template <typename Value>
SmoothTrack<Value> drift(double seconds, const Value& scale, RandomSource& random) {
  std::vector<Value> knots(static_cast<std::size_t>(seconds / idle_spacing) + 4);
  for (Value& knot : knots)
    for (Eigen::Index i = 0; i < knot.size(); ++i) knot[i] = scale[i] * random.uniform(-2.6, 2.6);
  return {-idle_spacing, idle_spacing, std::move(knots)};
}

}  // namespace

TrunkOffsets guard_stance() {
  TrunkOffsets guard = TrunkOffsets::Zero();
  guard[PelvisYaw] = -28 * radians_per_degree, guard[PelvisLean] = 7 * radians_per_degree;
  guard[ChestYaw] = -36 * radians_per_degree, guard[ChestLean] = 14 * radians_per_degree;
  guard[HeadLean] = 14 * radians_per_degree;
  guard[LeftHeel] = 5 * radians_per_degree, guard[RightHeel] = 22 * radians_per_degree;
  return guard;
}

double Pulse::at(double time) const {
  if (time <= start || time >= end) return 0;
  if (time < full) return minimum_jerk((time - start) / (full - start));
  if (time <= release) return 1;
  return 1 - minimum_jerk((time - release) / (end - release));
}

Fighter::Fighter(const DancerBody& body, const Performance& performance, const Spot& start, double seconds,
                 RandomSource& random)
    : body_(body),
      performance_(performance),
      start_(start),
      bounce_hz_(random.uniform(1.9, 2.4)),
      bounce_phase_(random.uniform(0, 2 * std::numbers::pi)),
      feet_{Footwork(stance_place(start, Side::Left), start.heading + stance_yaw(Side::Left)),
            Footwork(stance_place(start, Side::Right), start.heading + stance_yaw(Side::Right))},
      idle_(0, 1, {Idle::Zero()}) {
  // The root drifts less than the chest above it: the feet stand.
  const double trunk = 0.008 + performance.wander_m, hand = 0.010 + performance.wander_m;
  Idle scale = Idle::Constant(hand);
  scale.head<LeftHandX>() << 0.6 * trunk, 0.6 * trunk, trunk / 0.6, trunk / 0.6, trunk / 0.4, trunk / 0.6;
  idle_ = drift(seconds, scale, random);
}

Vec3 Fighter::stance_place(const Spot& spot, Side side) const {
  const double h = body_.height;
  const bool lead = side == Side::Left;
  const double wide = 0.92 + 0.08 * performance_.amplitude;
  return spot.place + forward_of(spot.heading) * (lead ? 0.135 : -0.100) * wide * h +
         left_of(spot.heading) * (lead ? 0.050 : -0.075) * h + Vec3(0, body_.toe_rest_height, 0);
}

double Fighter::stance_yaw(Side side) const {
  return (side == Side::Left ? -8 : -48) * radians_per_degree;
}

double Fighter::free_from(Side side) const {
  const Footwork& foot = feet_[index_of(side)];
  return std::max(foot.last().end, landed_[index_of(side)]);
}

double Fighter::free_from() const {
  return std::max(free_from(Side::Left), free_from(Side::Right));
}

Spot Fighter::spot(double time) const {
  const auto next = std::upper_bound(shuffles_.begin(), shuffles_.end(), time,
                                     [](double t, const Shuffle& shuffle) { return t < shuffle.start; });
  if (next == shuffles_.begin()) return start_;
  const Shuffle& now = *std::prev(next);
  const double done = minimum_jerk((time - now.start) / (now.end - now.start));
  return {blend(now.from.place, now.to.place, done), std::lerp(now.from.heading, now.to.heading, done)};
}

void Fighter::move_foot(Side side, double start, double end, const Spot& to) {
  feet_[index_of(side)].add({.start = start,
                             .end = end,
                             .toe_base = stance_place(to, side),
                             .yaw = to.heading + stance_yaw(side),
                             .lift = 0.016 * body_.height,
                             .heel = 0.10});
}

double Fighter::shuffle(double start, double duration, const Spot& to) {
  if (start < free_from()) throw std::invalid_argument("a shuffle begins before both feet have arrived");
  const Spot from = final_spot();
  const double steps =
      std::max(1.0, std::ceil((to.place - from.place).norm() / (longest_step * body_.height)));
  const double each = steps > 1 ? std::max(duration / steps, shortest_step) : duration;
  for (int i = 1; i <= static_cast<int>(steps); ++i)
    step(start + (i - 1) * each, each,
         {blend(from.place, to.place, i / steps), std::lerp(from.heading, to.heading, i / steps)});
  return shuffles_.back().end;
}

void Fighter::step(double start, double duration, const Spot& to) {
  const Spot from = final_spot();
  const Vec3 way = to.place - from.place;
  const double ahead = way.dot(forward_of(from.heading)), aside = way.dot(left_of(from.heading));
  const bool left_first = std::abs(ahead) > std::abs(aside) ? ahead > 0 : aside > 0;
  const Side first = left_first ? Side::Left : Side::Right, second = left_first ? Side::Right : Side::Left;
  move_foot(first, start, start + 0.53 * duration, to);
  move_foot(second, start + 0.47 * duration, start + duration, to);
  shuffles_.push_back({start, start + duration, from, to});
}

void Fighter::pivot(Side side, double start, double end, double yaw) {
  Footwork& foot = feet_[index_of(side)];
  foot.add({.start = start,
            .end = end,
            .toe_base = foot.last().toe_base,
            .yaw = final_spot().heading + stance_yaw(side) + yaw,
            .lift = 0,
            .heel = 0.10});
}

void Fighter::add(Side side, const LegMove& move) {
  if (move.chamber.start < free_from(side))
    throw std::invalid_argument("a foot is drawn up before it has arrived");
  leg_moves_[index_of(side)].push_back(move);
  landed_[index_of(side)] = move.chamber.end;
}

TrunkOffsets Fighter::offsets(double time) const {
  TrunkOffsets sum = guard_stance();
  for (const TrunkMove& move : trunk_moves_)
    if (time > move.pulse.start && time < move.pulse.end) sum += move.pulse.at(time) * move.offsets;
  const Idle idle = idle_.at(time);
  sum[Forward] += idle[SwayForward], sum[Leftward] += idle[SwayLeft];
  sum[ChestLean] += idle[IdleLean], sum[ChestTilt] += idle[IdleTilt], sum[ChestYaw] += idle[IdleYaw];
  sum[HeadLean] += idle[IdleHead];
  // Bouncing on the balls of the feet: the heels give as the knees do.
  const double bounce = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * bounce_hz_ * time + bounce_phase_);
  sum[Upward] -= 0.014 * performance_.amplitude * body_.height / 1.75 * bounce;
  sum[LeftHeel] += 5 * radians_per_degree * (1 - bounce),
      sum[RightHeel] += 5 * radians_per_degree * (1 - bounce);
  return sum;
}

TrunkPosture Fighter::trunk(const Spot& spot, const TrunkOffsets& o) const {
  const double across = 0.13 * body_.height, reach = guard_leg * body_.leg();
  const double hips = std::sqrt(reach * reach - across * across) + body_.ankle_rest_height();
  TrunkPosture trunk;
  trunk.root = spot.place + forward_of(spot.heading) * o[Forward] + left_of(spot.heading) * o[Leftward];
  trunk.root.y() = hips - body_.left_hip.y() + o[Upward];
  trunk.pelvis = leaning(spot.heading, o[PelvisYaw], o[PelvisLean], o[PelvisTilt]);
  trunk.chest = leaning(spot.heading, o[ChestYaw], o[ChestLean], o[ChestTilt]);
  trunk.head = {spot.heading + 0.15 * o[ChestYaw], o[HeadLean], -0.5 * o[ChestTilt]};
  return trunk;
}

PlacedTrunk Fighter::trunk_on(const Spot& spot, const TrunkOffsets& offsets) const {
  PlacedTrunk placed{.posture = trunk(spot, offsets)};
  place_trunk(body_, placed.posture, placed.pose);
  return placed;
}

FootPosture Fighter::foot(Side side, double time, const TrunkOffsets& offsets) const {
  FootPosture foot = feet_[index_of(side)].at(time);
  foot.heel_pitch += offsets[side == Side::Left ? LeftHeel : RightHeel];
  return foot;
}

bool Fighter::airborne(Side side, double time) const {
  const auto& moves = leg_moves_[index_of(side)];
  return std::any_of(moves.begin(), moves.end(), [&](const LegMove& move) {
    return time > move.chamber.start && time < move.chamber.end;
  });
}

double Fighter::overstretch(double time) const {
  const TrunkOffsets now = offsets(time);
  const Pose pose = trunk_on(spot(time), now).pose;
  double most = 0;
  for (const Side side : {Side::Left, Side::Right}) {
    if (airborne(side, time)) continue;
    const Vec3 leg = joint_at(pose, side == Side::Left ? left_hip : right_hip) -
                     ankle_position(body_, foot(side, time, now));
    const double across = std::hypot(leg.x(), leg.z()), reach = longest_leg * body_.leg();
    most = std::max(most, leg.y() - std::sqrt(std::max(0.0, reach * reach - across * across)));
  }
  return most;
}

void Fighter::settle(double seconds) {
  std::vector<double> needed;
  for (double time = 0; time <= seconds + lowered_spacing; time += lowered_spacing)
    needed.push_back(overstretch(time));
  // The largest around each moment, averaged over as long: smooth, and nowhere less than needed.
  const int count = static_cast<int>(needed.size()), half = 12;
  const auto around = [&](const std::vector<double>& of, int i) {
    return of[static_cast<std::size_t>(std::clamp(i, 0, count - 1))];
  };
  std::vector<double> highest(needed.size()), lowered(needed.size());
  for (int i = 0; i < count; ++i) {
    double most = 0;
    for (int k = -half; k <= half; ++k) most = std::max(most, around(needed, i + k));
    highest[static_cast<std::size_t>(i)] = most;
  }
  for (int i = 0; i < count; ++i) {
    double sum = 0;
    for (int k = 1 - half; k < half; ++k)
      sum += (1 + std::cos(std::numbers::pi * k / half)) * around(highest, i + k);
    lowered[static_cast<std::size_t>(i)] = sum / (2 * half);
  }
  lowered_ = {0, lowered_spacing, std::move(lowered)};
}

PlacedTrunk Fighter::trunk_at(double time, const TrunkOffsets& offsets) const {
  PlacedTrunk placed{.posture = trunk(spot(time), offsets)};
  placed.posture.root.y() -= lowered_.at(time);
  place_trunk(body_, placed.posture, placed.pose);
  return placed;
}

PlacedTrunk Fighter::trunk_at(double time) const {
  return trunk_at(time, offsets(time));
}

void Fighter::place_leg(Side side, double time, const TrunkOffsets& offsets, PlacedTrunk& placed) const {
  const FootPosture standing = foot(side, time, offsets);
  const double pelvis_yaw = placed.posture.pelvis.yaw;
  const auto& moves = leg_moves_[index_of(side)];
  const auto move = std::find_if(moves.begin(), moves.end(), [&](const LegMove& m) {
    return time > m.chamber.start && time < m.chamber.end;
  });
  if (move == moves.end()) return abrazo::place_leg(body_, side, standing, pelvis_yaw, placed.pose);
  const Eigen::Matrix3d pelvis = placed.posture.pelvis.matrix();
  const double drawn = move->chamber.at(time), struck = move->strike.at(time);
  const Vec3 hip = joint_at(placed.pose, side == Side::Left ? left_hip : right_hip);
  LiftedFoot lifted{.hinge = pelvis * move->hinge, .pointed = move->pointed, .share = drawn};
  lifted.ankle = blend(ankle_position(body_, standing), hip + pelvis * move->drawn_up, drawn);
  lifted.ankle = blend(lifted.ankle, move->target, struck) + arm_swing(struck) * move->arc +
                 move->swept.at(time) * move->sweep;
  place_lifted_leg(body_, side, standing, pelvis_yaw, lifted, placed.pose);
}

Vec3 Fighter::guard_hand(Side side, const PlacedTrunk& trunk, double heading) const {
  const double arm = (body_.upper_arm + body_.forearm + body_.hand) / 0.63;
  const Vec3 place = side == Side::Left ? Vec3(0.085, 0.075, 0.37) : Vec3(-0.085, 0.085, 0.21);
  // The guard follows a turn of the shoulders, by half.
  const double yaw = heading + 0.5 * (trunk.posture.chest.yaw - heading - guard_stance()[ChestYaw]);
  return joint_at(trunk.pose, LowerNeck) + arm * (Turn{.yaw = yaw}.matrix() * place);
}

void Fighter::place_arm(Side side, double time, PlacedTrunk& placed) const {
  const double heading = spot(time).heading;
  Vec3 hand = guard_hand(side, placed, heading);
  hand += Turn{.yaw = heading}.matrix() *
          idle_.at(time).segment<3>(side == Side::Left ? LeftHandX : RightHandX).matrix();
  Vec3 elbow(0.45, -0.85, -0.10);
  for (const HandMove& move : hand_moves_[index_of(side)]) {
    if (time <= move.pulse.start || time >= move.pulse.end) continue;
    const double gone = move.pulse.at(time);
    hand = blend(hand, move.target, gone) + arm_swing(gone) * move.arc + move.swept.at(time) * move.sweep;
    elbow = blend(elbow, move.elbow, gone);
  }
  place_fist(body_, side, hand, elbow, placed.posture.chest, placed.pose);
}

Pose Fighter::pose(double time) const {
  const TrunkOffsets now = offsets(time);
  PlacedTrunk placed = trunk_at(time, now);
  for (const Side side : {Side::Left, Side::Right}) {
    place_leg(side, time, now, placed);
    place_arm(side, time, placed);
  }
  return placed.pose;
}

}  // namespace abrazo
