#include "core/synthesis/motion/partner_place.hpp"

#include <algorithm>
#include <cmath>

#include "core/selection/source_playhead.hpp"

namespace abrazo {

namespace {

// Beyond these the spring pulls no harder: a partner that is far off walks there, and does not fly.
constexpr double farthest_pull_m = 0.24;
constexpr double farthest_turn_rad = 1.0;

constexpr double damping = 1.2;          // zeta; above 1
constexpr double recorded_share = 0.75;  // beta

/// x'' = -omega^2 x - 2 omega x', exactly.
void relax_critically(double& off, double& speed, double elapsed_s, double omega) {
  const double slope = speed + omega * off;
  const double shrink = std::exp(-omega * elapsed_s);
  off = shrink * (off + elapsed_s * slope);
  speed = shrink * (speed - (omega * elapsed_s) * slope);
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

}  // namespace

Vec3 PartnerPlace::way_to(const RootFrame& wanted) const {
  Vec3 way = wanted.position - at_.position;
  way.y() = 0;
  return way.norm() > farthest_pull_m ? Vec3(way * (farthest_pull_m / way.norm())) : way;
}

void PartnerPlace::advance(const RecordedPath& path, const RootFrame& wanted, double elapsed_s, double rate,
                           const Vec3& drawn) {
  RootFrame half_way = at_;
  half_way.heading_rad += 0.5 * path.turn;
  const double heading = at_.heading_rad + path.turn;
  double turned_off =
      std::clamp(within_half_turn(heading - wanted.heading_rad), -farthest_turn_rad, farthest_turn_rad);
  const double near_turn = heading - turned_off;
  relax_critically(turned_off, turning_, elapsed_s, rate);
  at_.heading_rad = within_half_turn(near_turn + turned_off);
  if (elapsed_s <= 0) return;
  // Where the spring would rest while the recording moves on.
  const Vec3 rest = (2 * damping * recorded_share / (rate * elapsed_s)) * (half_way.rotation() * path.own);
  Vec3 off = -(way_to(wanted) + drawn);
  const Vec3 near = at_.position - off + rest;
  off -= rest;
  relax_overdamped(off, speed_, elapsed_s, rate);
  at_.position = near + off;
}

}  // namespace abrazo
