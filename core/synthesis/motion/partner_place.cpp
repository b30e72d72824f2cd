#include "core/synthesis/motion/partner_place.hpp"

#include <algorithm>
#include <cmath>

#include "core/selection/source_playhead.hpp"

namespace abrazo {

namespace {

// Beyond these the spring pulls no harder: a partner that is far off walks there, and does not fly.
constexpr double farthest_pull_m = 0.24;
constexpr double farthest_turn_rad = 1.0;

/// x'' = -omega^2 x - 2 omega x', exactly.
template <typename Value>
void relax_critically(Value& off, Value& speed, double elapsed_s, double omega) {
  const Value slope = speed + omega * off;
  const double shrink = std::exp(-omega * elapsed_s);
  off = shrink * (off + elapsed_s * slope);
  speed = shrink * (speed - (omega * elapsed_s) * slope);
}

}  // namespace

void PartnerPlace::carry(const Vec3& own_path, double turn_rad) {
  RootFrame half_way = at_;
  half_way.heading_rad += 0.5 * turn_rad;
  at_.position += half_way.rotation() * own_path;
  at_.heading_rad = within_half_turn(at_.heading_rad + turn_rad);
}

void PartnerPlace::keep_speed(const Vec3& lost_speed, double lost_turning) {
  speed_ += lost_speed;
  turning_ += lost_turning;
}

Vec3 PartnerPlace::way_to(const RootFrame& wanted) const {
  Vec3 way = wanted.position - at_.position;
  way.y() = 0;
  return way.norm() > farthest_pull_m ? Vec3(way * (farthest_pull_m / way.norm())) : way;
}

void PartnerPlace::approach(const RootFrame& wanted, double elapsed_s, double rate, const Vec3& drawn) {
  Vec3 off = -(way_to(wanted) + drawn);
  const Vec3 near = at_.position - off;
  relax_critically(off, speed_, elapsed_s, rate);
  double turned_off = std::clamp(within_half_turn(at_.heading_rad - wanted.heading_rad), -farthest_turn_rad,
                                 farthest_turn_rad);
  const double near_turn = at_.heading_rad - turned_off;
  relax_critically(turned_off, turning_, elapsed_s, rate);
  at_ = {near + off, within_half_turn(near_turn + turned_off)};
}

}  // namespace abrazo
