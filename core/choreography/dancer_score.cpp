#include "core/choreography/dancer_score.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace abrazo {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double full_turn = 2 * std::numbers::pi;
constexpr double foot_spacing = 0.085;    ///< foot from the dancer's middle [m]
constexpr double toe_base_ahead = 0.050;  ///< of the spot, with the weight over the middle of the foot [m]
constexpr double toe_out = 7 * degree;

using HalfBeats = std::array<double, 16>;  ///< a value for every half-beat of a phrase, from count 1

// The leader's basic; the follower's is its mirror image.
constexpr HalfBeats root_forward = {.52,  .55,  .30,  .12,  .02,  0, 0, -.12,
                                    -.50, -.55, -.30, -.12, -.02, 0, 0, .12};
constexpr HalfBeats root_left = {.8, .6, -.6, -1, .3, 1, 1, .4, -.8, -.6, .6, 1, -.3, -1, -1, -.4};
constexpr HalfBeats hip_yaw = {-1, -.6, 0, .5, .8, .3, -.1, .6, 1, .6, 0, -.5, -.8, -.3, .1, -.6};
// Heel of the foot that is left behind without weight.
constexpr HalfBeats left_heel = {0, 0, 0, 0, 0, 0, 0, .2, .8, .6, .1, 0, 0, 0, 0, 0};
constexpr HalfBeats right_heel = {.9, .7, .1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, .2};

// The follower's turn to her right, in degrees, wound up a little before; and how far she looks at her
// partner meanwhile.
constexpr HalfBeats turn_degrees = {0,   0,    4,    8,    10,   6,    -6,   -32,
                                    -78, -136, -200, -262, -312, -344, -358, -360};
constexpr HalfBeats turn_gaze = {1, 1, 1, 1, 1, 1, .8, .3, 0, 0, 0, 0, 0, .3, .8, 1};

struct BasicStep {
  double beat;
  Side side;
  double forward;  ///< in step lengths
  double lift;     ///< [m]
};
constexpr std::array<BasicStep, 6> basic_steps = {{{0, Side::Left, 1, .060},
                                                   {1, Side::Right, 0, .030},
                                                   {2, Side::Left, 0, .055},
                                                   {4, Side::Right, -1, .060},
                                                   {5, Side::Left, 0, .030},
                                                   {6, Side::Right, 0, .055}}};
constexpr double swing_beats = 0.88;

constexpr Side other(Side side) {
  return side == Side::Left ? Side::Right : Side::Left;
}
std::size_t index_of(int half_beat) {
  return static_cast<std::size_t>(half_beat);
}

}  // namespace

DancerScore::DancerScore(DanceRole role, const DancerBody& body, const std::vector<SalsaPhrase>& phrases,
                         const CouplePath& path)
    : role_(role),
      body_(body),
      left_(placement(spot(0, path), Side::Left, 0, 0), spot(0, path).heading + toe_out),
      right_(placement(spot(0, path), Side::Right, 0, 0), spot(0, path).heading - toe_out),
      trunk_(0, 0.5, {}) {
  write_steps(phrases, path);
  turned_ = 0;
  write_trunk(phrases, path);
}

Spot DancerScore::spot(double beat, const CouplePath& path) const {
  return role_ == DanceRole::Leader ? path.leader(beat) : path.follower(beat);
}

Vec3 DancerScore::placement(const Spot& at, Side side, double forward, double turned) const {
  const double heading = at.heading + turned;
  return at.place + forward_of(heading) * (toe_base_ahead + forward) +
         left_of(heading) * (sign_of(side) * foot_spacing) + Vec3(0, body_.toe_rest_height, 0);
}

void DancerScore::write_steps(const std::vector<SalsaPhrase>& phrases, const CouplePath& path) {
  const bool leads = role_ == DanceRole::Leader;
  for (std::size_t p = 0; p < phrases.size(); ++p) {
    const double first_beat = beats_per_phrase * static_cast<double>(p);
    const bool turns = !leads && phrases[p].move == SalsaMove::Turn;
    for (const BasicStep& step : basic_steps) {
      if (turns && step.beat > 3) break;
      const Side side = leads ? step.side : other(step.side);
      const bool walks = phrases[p].move == SalsaMove::CrossBodyLead && step.beat > 3;
      const double forward = walks ? 0 : (leads ? 1 : -1) * step.forward * phrases[p].step;
      const double arrival = first_beat + step.beat;
      // A step is placed where the dancer will be a little later; further ahead when they walk past each
      // other.
      const bool passes = phrases[p].move == SalsaMove::CrossBodyLead && step.beat > 0.5;
      const Spot at = spot(arrival + (passes ? 0.9 : 0.3), path);
      feet(side).add({.start = arrival - swing_beats,
                      .end = arrival,
                      .toe_base = placement(at, side, forward, turned_),
                      .yaw = spot(arrival + 1, path).heading + turned_ + sign_of(side) * toe_out,
                      .lift = walks ? 0.055 : step.lift,
                      .heel = step.forward == 0 ? 0.28 : 0.36});
    }
    if (turns) write_turn_steps(first_beat, phrases[p], path);
    if (phrases[p].move == SalsaMove::CrossBodyLead)
      write_pivot(first_beat, leads ? Side::Left : Side::Right, path);
  }
}

void DancerScore::write_pivot(double first_beat, Side side, const CouplePath& path) {
  feet(side).add({.start = first_beat + 5.2,
                  .end = first_beat + 6.9,
                  .toe_base = feet(side).last().toe_base,
                  .yaw = spot(first_beat + 7.5, path).heading + turned_ + sign_of(side) * toe_out,
                  .lift = 0,
                  .heel = 0.12});
}

void DancerScore::write_turn_steps(double first_beat, const SalsaPhrase& phrase, const CouplePath& path) {
  struct TurnStep {
    Side side;
    double start, end;
    double body_degrees;  ///< how far she has turned where the step is placed
    double foot_degrees;
    double forward;  ///< in step lengths
    double lift;     ///< 0: pivots on the ball of the foot
  };
  static constexpr std::array<TurnStep, 7> steps = {{{Side::Right, 2.9, 4.0, 0, -45, 0, 0},
                                                     {Side::Left, 3.2, 4.0, -70, -85, .35, .05},
                                                     {Side::Left, 4.05, 5.0, 0, -180, 0, 0},
                                                     {Side::Right, 4.2, 5.0, -215, -250, .15, .05},
                                                     {Side::Right, 5.05, 6.0, 0, -315, 0, 0},
                                                     {Side::Left, 5.2, 6.0, -345, -350, 0, .05},
                                                     {Side::Right, 6.25, 7.0, -360, -360, 0, .025}}};
  for (const TurnStep& step : steps) {
    const Spot at = spot(first_beat + step.end + 0.3, path);
    Footwork& foot = feet(step.side);
    const Vec3 place = step.lift > 0 ? placement(at, step.side, step.forward * phrase.step,
                                                 turned_ + step.body_degrees * degree)
                                     : foot.last().toe_base;
    foot.add({.start = first_beat + step.start,
              .end = first_beat + step.end,
              .toe_base = place,
              .yaw = at.heading + turned_ + step.foot_degrees * degree + sign_of(step.side) * toe_out,
              .lift = step.lift,
              .heel = step.lift > 0 ? 0.4 : 0.15});
  }
  turned_ -= full_turn;
}

void DancerScore::write_trunk(const std::vector<SalsaPhrase>& phrases, const CouplePath& path) {
  std::vector<Controls> values;
  for (std::size_t p = 0; p < phrases.size(); ++p) {
    for (int half_beat = 0; half_beat < 16; ++half_beat)
      values.push_back(controls(phrases[p], half_beat, 8.0 * static_cast<double>(p) + 0.5 * half_beat, path));
    if (role_ == DanceRole::Follower && phrases[p].move == SalsaMove::Turn) turned_ -= full_turn;
  }
  trunk_ = {0, 0.5, std::move(values)};
}

DancerScore::Controls DancerScore::controls(const SalsaPhrase& phrase, int half_beat, double beat,
                                            const CouplePath& path) const {
  const std::size_t h = index_of(half_beat);
  const bool leads = role_ == DanceRole::Leader;
  const bool turns = !leads && phrase.move == SalsaMove::Turn;
  const double mirror = leads ? 1 : -1;
  const bool passes = phrase.move == SalsaMove::CrossBodyLead;
  const bool round = (turns || passes) && half_beat >= 6;
  const Spot at = spot(beat, path);
  const double heading = at.heading + turned_ + (turns ? turn_degrees[h] * degree : 0);
  // While they walk past each other or she goes round, the weight stays over the spot.
  const double forward = mirror * root_forward[h] * phrase.step * (round ? 0.35 : 1);
  const double sideways = mirror * root_left[h] * 0.060 * (round ? 0.5 : 1);
  const Vec3 root =
      at.place + forward * forward_of(round ? at.heading : heading) + sideways * left_of(heading);
  const double hips = phrase.hips;
  Controls values;
  values[RootX] = root.x();
  values[RootY] = body_.standing_root_height(0.950) - 0.020 * hips * (half_beat % 2);
  values[RootZ] = root.z();
  values[PelvisYaw] = heading + mirror * hip_yaw[h] * (leads ? 11 : 15) * degree * hips * (round ? 0.2 : 1);
  values[PelvisPitch] = (leads ? 2 : 5) * degree;
  values[PelvisRoll] = mirror * root_left[h] * (leads ? 8 : 13) * degree * hips * (round ? 0.5 : 1);
  values[ChestYaw] = heading - mirror * hip_yaw[h] * (leads ? 6 : 9) * degree * hips * (round ? 0.2 : 1);
  values[ChestPitch] = (leads ? 4 : 1) * degree + 1.5 * degree * (half_beat % 4 == 0 ? 1 : 0);
  values[ChestRoll] = -mirror * root_left[h] * (leads ? 7 : 8) * degree * hips * (round ? 0.5 : 1);
  if (leads && phrase.move == SalsaMove::Turn && half_beat >= 3 && half_beat <= 13)
    values[ChestYaw] -= 16 * degree;
  values[HeadPitch] = (leads ? 9 : 2) * degree + 3 * degree * std::sin(0.9 * beat);
  values[Gaze] = turns ? turn_gaze[h] : passes ? 0.6 : 0.85;
  values[LeftHeel] = round ? 0 : (leads ? left_heel : right_heel)[h] * 26 * degree;
  values[RightHeel] = round ? 0 : (leads ? right_heel : left_heel)[h] * 26 * degree;
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
  const double aside = std::remainder(gaze_yaw - trunk.chest.yaw, full_turn);
  trunk.head = {trunk.chest.yaw + now[Gaze] * aside, now[HeadPitch], 0.4 * now[ChestRoll]};
  return trunk;
}

}  // namespace abrazo
