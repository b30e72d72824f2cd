#include "core/synthesis/motion/partner_place.hpp"

#include <algorithm>
#include <cmath>

#include "core/selection/source_playhead.hpp"

namespace abrazo {

namespace {

// The springs pull no harder than over these: a partner that is far off walks there, and does not fly.
constexpr double farthest_pull_m = 0.35;  // l, reached gradually
constexpr double farthest_turn_rad = 1.0;

constexpr double recorded_share = 0.6, recorded_lag_s = 0.3;  // beta, tau
constexpr double desired_share = 0.4, desired_lag_s = 0.06;   // gamma, tau_D
constexpr double fastest_desired = 1.6;                       ///< [m/s]
constexpr double turning_rate = 8;                            // omega of the heading [1/s]

/// x'' = -omega^2 x - 2 omega x', exactly.
template <typename Value>
void relax_critically(Value& off, Value& speed, double elapsed_s, double omega) {
  const Value slope = speed + omega * off;
  const double shrink = std::exp(-omega * elapsed_s);
  off = shrink * (off + elapsed_s * slope);
  speed = shrink * (speed - (omega * elapsed_s) * slope);
}

/// Low-pass filter of an input that is constant during a step, exactly. @return mean of the output
Vec3 follow(Vec3& filtered, const Vec3& input, double elapsed_s, double lag_s) {
  const double passed = elapsed_s / lag_s, left = std::exp(-passed);
  const Vec3 behind = filtered - input;
  filtered = input + left * behind;
  return input + ((1 - left) / passed) * behind;
}

/// s(e), horizontal.
Vec3 pull(const Vec3& from, const RootFrame& wanted) {
  Vec3 way = wanted.position - from;
  way.y() = 0;
  return way / (1 + way.norm() / farthest_pull_m);
}

}  // namespace

Vec3 PartnerPlace::way_to(const RootFrame& wanted) const {
  return pull(at_.position, wanted);
}

void PartnerPlace::advance(const RecordedStep& recorded, const RootFrame& wanted, double elapsed_s,
                           double rate, const Vec3& drawn) {
  RootFrame half_way = at_;
  half_way.heading_rad += 0.5 * recorded.turn;
  const double heading = at_.heading_rad + recorded.turn;
  double turned_off =
      std::clamp(within_half_turn(heading - wanted.heading_rad), -farthest_turn_rad, farthest_turn_rad);
  const double near_turn = heading - turned_off;
  relax_critically(turned_off, turning_, elapsed_s, turning_rate);
  at_.heading_rad = within_half_turn(near_turn + turned_off);
  if (elapsed_s <= 0) return;
  const Vec3 carries =
      follow(recorded_speed_, half_way.rotation() * recorded.speed, elapsed_s, recorded_lag_s);
  Vec3 moves = desired_ ? Vec3((wanted.position - *desired_) / elapsed_s) : Vec3::Zero();
  moves.y() = 0;
  if (moves.norm() > fastest_desired) moves.setZero();
  desired_ = wanted.position;
  const Vec3 leads = follow(desired_speed_, moves, elapsed_s, desired_lag_s);
  // Where the spring would rest while the recording and the desired place move on.
  const Vec3 rest = (2 / rate) * (recorded_share * carries + desired_share * leads);
  // The pull is that of the middle of the step, which makes the bound right to second order.
  const Vec3 middle = at_.position + 0.5 * elapsed_s * speed_;
  const Vec3 near = middle + pull(middle, wanted) + drawn + rest;
  Vec3 off = at_.position - near;
  relax_critically(off, speed_, elapsed_s, rate);
  at_.position = near + off;
}

}  // namespace abrazo
