#include "core/choreography/dancer_score.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/units.hpp"

namespace abrazo {
namespace {

constexpr double toe_base_ahead = 0.050;  ///< of the spot, with the weight over the middle of the foot [m]
constexpr double toe_out = 7 * radians_per_degree;
constexpr double swing_beats = 0.90;
constexpr int controls_per_beat = 4;

struct BasicStep {
  double beat;
  Side side;       ///< the leader's
  double forward;  ///< in step lengths
  double lift;     ///< [m]
  double look;     ///< to the middle of the time the foot stands [beats]
};
// Closing on 3 and 7 the foot goes a little past the other, so that the body swings on to the next step.
constexpr std::array<BasicStep, 6> basic_steps = {{{0, Side::Left, 1, .065, .55},
                                                   {1, Side::Right, .25, .045, .95},
                                                   {2, Side::Left, -.35, .060, .95},
                                                   {4, Side::Right, -1, .065, .55},
                                                   {5, Side::Left, -.25, .045, .95},
                                                   {6, Side::Right, .35, .060, .95}}};

/// Foot from the dancer's middle [m].
double foot_spacing(DanceRole role) {
  return role == DanceRole::Leader ? 0.100 : 0.075;
}

constexpr Side other(Side side) {
  return side == Side::Left ? Side::Right : Side::Left;
}

/// How much of the basic step is danced to and fro, and how far the trunk goes with the weight instead of
/// staying on the spot.
struct Manner {
  double step, over_foot;
};
Manner manner(const SalsaPhrase& phrase, DanceRole role, double beat) {
  const bool leads = role == DanceRole::Leader;
  const bool second_half = beat > 2.5;
  using enum SalsaFigure;
  switch (phrase.figure) {
    case OpenBasic:
    case ClosedBasic:
      return {1, leads ? 0.45 : 0.60};
    case FollowerRightTurn:
    case FollowerLeftTurn:
      return second_half && !leads ? Manner{0.2, 0.4} : Manner{0.8, 0.5};
    case LeaderRightTurn:
    case LeaderLeftTurn:
      return second_half && leads ? Manner{0.2, 0.4} : Manner{0.8, 0.5};
    case CrossBodyLead:
    case InsideTurn:
      return second_half ? Manner{0, 0.35} : Manner{1, 0.5};
    case InAndOut:
      return leads ? Manner{0.6, 0.5} : Manner{0, 0.35};
    default:
      return {0, 0.35};
  }
}

/// Share of the weight on the left foot. It is taken over around the moment a foot comes down.
/// @param spread  how long that takes [beats]
double weight_on_left(DanceRole role, double beat, double spread) {
  const double inside = beat - beats_per_phrase * std::floor(beat / beats_per_phrase);
  bool left = role == DanceRole::Follower;  // the leader's right, set down on 7
  double weight = left ? 1 : 0;
  for (int i = 0; i <= 6; ++i) {
    const bool next = i == 6;
    const auto& step = basic_steps[static_cast<std::size_t>(i % 6)];
    const double since = inside - step.beat - (next ? beats_per_phrase : 0);
    const double taken = minimum_jerk(since / spread + 0.55);
    left = (step.side == Side::Left) == (role == DanceRole::Leader);
    weight = std::lerp(weight, left ? 1.0 : 0.0, taken);
  }
  return weight;
}

}  // namespace

DancerScore::DancerScore(DanceRole role, const DancerBody& body, const std::vector<SalsaPhrase>& phrases,
                         const CouplePath& path, double amplitude)
    : role_(role),
      body_(body),
      amplitude_(amplitude),
      left_(placement(spot(0, path), Side::Left, 0), spot(0, path).heading + toe_out),
      right_(placement(spot(0, path), Side::Right, 0), spot(0, path).heading - toe_out),
      trunk_(0, 1, {}) {
  write_steps(phrases, path);
  write_trunk(phrases, path);
}

Spot DancerScore::spot(double beat, const CouplePath& path) const {
  return role_ == DanceRole::Leader ? path.leader(beat) : path.follower(beat);
}

Vec3 DancerScore::placement(const Spot& at, Side side, double forward) const {
  return at.place + forward_of(at.heading) * (toe_base_ahead + forward) +
         left_of(at.heading) * (sign_of(side) * foot_spacing(role_)) + Vec3(0, body_.toe_rest_height, 0);
}

void DancerScore::write_steps(const std::vector<SalsaPhrase>& phrases, const CouplePath& path) {
  const bool leads = role_ == DanceRole::Leader;
  for (std::size_t p = 0; p < phrases.size(); ++p) {
    const double first_beat = beats_per_phrase * static_cast<double>(p);
    for (const BasicStep& step : basic_steps) {
      const Side side = leads ? step.side : other(step.side);
      const double arrival = first_beat + step.beat;
      const double forward = (leads ? 1 : -1) * step.forward * phrases[p].step * amplitude_ *
                             manner(phrases[p], role_, step.beat).step;
      // A foot is set where the dancer will be when standing on it.
      const Spot place = spot(arrival + step.look, path);
      const Spot facing = spot(arrival + 0.15, path);
      write_pivot(side, arrival - swing_beats, path);
      Footwork& foot = feet(side);
      const FootMove& from = foot.last();
      FootMove move{.start = arrival - swing_beats,
                    .end = arrival,
                    .toe_base = placement({place.place, facing.heading}, side, forward),
                    .yaw = facing.heading + sign_of(side) * toe_out,
                    .lift = step.lift,
                    .heel = std::abs(step.forward) < 0.3 ? 0.12 : 0.18,
                    .detour = Vec3::Zero()};
      const Vec3 standing = feet(other(side)).last().toe_base;
      const Vec3 aside = 0.5 * (from.toe_base + move.toe_base) - standing;
      const double clearance = 0.13;
      if (aside.norm() < clearance && aside.norm() > 1e-6)
        move.detour = aside.normalized() * (clearance - aside.norm());
      foot.add(move);
    }
  }
}

/// The foot turns on its ball with the dancer until it is lifted.
void DancerScore::write_pivot(Side side, double until, const CouplePath& path) {
  Footwork& foot = feet(side);
  const FootMove last = foot.last();
  const double start = last.end + 0.02;
  if (until - start < 0.15) return;
  const double yaw = spot(until, path).heading + sign_of(side) * toe_out;
  foot.add({.start = start,
            .end = until,
            .toe_base = last.toe_base,
            .yaw = yaw,
            .lift = 0,
            .heel = std::min(0.25, 0.05 + 0.3 * std::abs(yaw - last.yaw)),
            .detour = Vec3::Zero()});
}

void DancerScore::write_trunk(const std::vector<SalsaPhrase>& phrases, const CouplePath& path) {
  std::vector<Controls> values;
  for (std::size_t p = 0; p < phrases.size(); ++p)
    for (int i = 0; i < beats_per_phrase * controls_per_beat; ++i)
      values.push_back(controls(
          phrases[p], beats_per_phrase * static_cast<double>(p) + static_cast<double>(i) / controls_per_beat,
          path));
  trunk_ = {0, 1.0 / controls_per_beat, std::move(values)};
}

DancerScore::Controls DancerScore::controls(const SalsaPhrase& phrase, double beat,
                                            const CouplePath& path) const {
  const bool leads = role_ == DanceRole::Leader;
  const Spot at = spot(beat, path);
  const Vec3 forward = forward_of(at.heading), left = left_of(at.heading);
  const double inside = beat - beats_per_phrase * std::floor(beat / beats_per_phrase);
  const double over_foot = manner(phrase, role_, inside).over_foot;
  const double weight = weight_on_left(role_, beat, 0.9),
               hip_weight = weight_on_left(role_, beat - 0.2, leads ? 1.0 : 0.7);
  const double carriage = weight_on_left(role_, beat, leads ? 1.2 : 0.9);
  const Vec3 left_foot = left_.at(beat).toe_base, right_foot = right_.at(beat).toe_base;
  const Vec3 carried =
      carriage * left_foot + (1 - carriage) * right_foot - toe_base_ahead * forward - at.place;
  const double hips = phrase.hips * amplitude_, lean = leads ? phrase.his_lean : phrase.her_lean;
  const double carried_forward = carried.dot(forward) / 0.3;
  const Vec3 root = at.place + over_foot * carried.dot(forward) * forward +
                    (leads ? 0.5 : 0.9) * hips * carried.dot(left) * left;
  // The hip goes forward with its foot, and back when it takes the weight.
  const double stride = std::clamp((left_foot - right_foot).dot(forward) / 0.32, -1.3, 1.3);
  const double sway = 2 * hip_weight - 1;
  const double twist = hips * radians_per_degree * (leads ? 13 : 12) * (0.5 * sway - 0.7 * stride);
  // The whole body turns a little away from the partner and back with every half of the basic.
  const double swing =
      hips * radians_per_degree * (leads ? 10 : -19) *
      (std::sin(std::numbers::pi / 4 * (beat - 0.6)) + 0.8 * std::sin(std::numbers::pi / 2 * (beat - 0.9)));
  const double bounce = std::cos(2 * std::numbers::pi * (beat - 0.15));
  Controls values;
  values[RootX] = root.x();
  values[RootY] = body_.standing_root_height(0.935) + (leads ? 0.003 : 0.014) * hips * bounce;
  values[RootZ] = root.z();
  values[PelvisYaw] = at.heading + twist + swing;
  values[PelvisPitch] =
      (leads ? 2 : 5) * radians_per_degree + (leads ? 0.5 : 2.0) * radians_per_degree * bounce + 0.5 * lean;
  values[PelvisRoll] = sway * hips * radians_per_degree * (leads ? 5.5 : 12);
  values[ChestYaw] = at.heading - 0.8 * twist + 0.6 * swing;
  // His right arm reaches round her.
  if (leads && phrase.figure == SalsaFigure::ClosedBasic) values[ChestYaw] += 9 * radians_per_degree;
  values[ChestPitch] = (leads ? 4 : 2) * radians_per_degree -
                       (leads ? 0.5 : 2.0) * radians_per_degree * bounce + lean -
                       4 * radians_per_degree * carried_forward;
  values[ChestRoll] = -6 * radians_per_degree * sway * hips - 1.5 * radians_per_degree;
  values[HeadPitch] = (leads ? 9 : 2) * radians_per_degree + 3 * radians_per_degree * std::sin(0.9 * beat);
  // Heel of the foot that is left behind without weight.
  values[LeftHeel] = (1 - weight) * 27 * radians_per_degree;
  values[RightHeel] = weight * 27 * radians_per_degree;
  return values;
}

FootPosture DancerScore::foot(Side side, double beat) const {
  FootPosture foot = (side == Side::Left ? left_ : right_).at(beat);
  foot.heel_pitch += trunk_.at(beat)[side == Side::Left ? LeftHeel : RightHeel];
  return foot;
}

TrunkPosture DancerScore::trunk(double beat, double gaze_yaw) const {
  const Controls now = trunk_.at(beat);
  TrunkPosture trunk;
  trunk.root = {now[RootX], now[RootY], now[RootZ]};
  trunk.pelvis = {now[PelvisYaw], now[PelvisPitch], now[PelvisRoll]};
  trunk.chest = {now[ChestYaw], now[ChestPitch], now[ChestRoll]};
  // The head turns to the partner as far as a neck does, and comes about with the body when turned away.
  const double aside = std::sin(gaze_yaw - trunk.chest.yaw);
  trunk.head = {trunk.chest.yaw + 50 * radians_per_degree * aside, now[HeadPitch], 0.4 * now[ChestRoll]};
  return trunk;
}

}  // namespace abrazo
