#include "core/synthesis/motion/partner_place.hpp"

#include <algorithm>
#include <cmath>

#include "core/selection/source_playhead.hpp"

namespace abrazo {

namespace {

// The springs pull no harder than over these: a partner that is far off walks there, and does not fly.
constexpr double farthest_pull_m = 0.32;  // l, reached gradually
constexpr double farthest_turn_rad = 1.0;

constexpr double damping = 1.25;             // zeta; above 1
constexpr double recorded_share = 0.8;       // beta
constexpr double recorded_speed_lag = 0.13;  // tau [s]
constexpr double turning_rate = 8;           // omega of the heading [1/s]

/// x'' = -omega^2 x - 2 omega x', exactly.
void relax_critically(double& off, double& speed, double elapsed_s, double omega) {
  const double slope = speed + omega * off;
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

/// x'' = -omega^2 x - 2 zeta omega x', exactly.
void relax_overdamped(Vec3& off, Vec3& speed, double elapsed_s, double omega) {
  const double root = std::sqrt(damping * damping - 1);
  const double slow = omega * (damping - root), fast = omega * (damping + root);
  const Vec3 slowly = (fast * off + speed) / (fast - slow), quickly = off - slowly;
  const double slow_left = std::exp(-slow * elapsed_s), fast_left = std::exp(-fast * elapsed_s);
  off = slow_left * slowly + fast_left * quickly;
  speed = -slow * slow_left * slowly - fast * fast_left * quickly;
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

void PartnerPlace::advance(const RecordedPath& path, const RootFrame& wanted, double elapsed_s, double rate,
                           const Vec3& drawn) {
  RootFrame half_way = at_;
  half_way.heading_rad += 0.5 * path.turn;
  const double heading = at_.heading_rad + path.turn;
  double turned_off =
      std::clamp(within_half_turn(heading - wanted.heading_rad), -farthest_turn_rad, farthest_turn_rad);
  const double near_turn = heading - turned_off;
  relax_critically(turned_off, turning_, elapsed_s, turning_rate);
  at_.heading_rad = within_half_turn(near_turn + turned_off);
  if (elapsed_s <= 0) return;
  const Vec3 carries =
      follow(recorded_speed_, half_way.rotation() * path.own / elapsed_s, elapsed_s, recorded_speed_lag);
  // Where the spring would rest while the recording moves on.
  const Vec3 rest = (2 * damping * recorded_share / rate) * carries;
  // The pull is that of the middle of the step, which makes the bound right to second order.
  const Vec3 middle = at_.position + 0.5 * elapsed_s * speed_;
  const Vec3 near = middle + pull(middle, wanted) + drawn + rest;
  Vec3 off = at_.position - near;
  relax_overdamped(off, speed_, elapsed_s, rate);
  at_.position = near + off;
}

}  // namespace abrazo
