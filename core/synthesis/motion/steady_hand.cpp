#include "core/synthesis/motion/steady_hand.hpp"

#include <algorithm>

namespace abrazo {

namespace {
// Hands of dancers stay below 100 m/s^2 in 999 of 1000 captured frames; jumps to and fro have 200 to 300.
constexpr double most_acceleration = 100;  ///< [m/s^2]
constexpr double share_beyond = 0.2;
constexpr double share_to_and_fro = 0.25;
// In longer steps a hand may really turn round; at twice this length nothing is taken for a jump to and fro.
constexpr double jumps_to_and_fro_in_s = 1.0 / 60;
constexpr double share_of_speed = 0.5;
}  // namespace

void SteadyHand::follow(const Vec3& measured, double elapsed_s) {
  if (!is_seen || elapsed_s <= 0) {
    *this = {true, measured, Vec3::Zero(), Vec3::Zero()};
    return;
  }
  const Vec3 expected = at + elapsed_s * speed;
  const Vec3 off = measured - expected;
  double share = 1;
  if (off.dot(last_off) < 0)
    share = std::clamp(share_to_and_fro + (elapsed_s / jumps_to_and_fro_in_s - 1) * (1 - share_to_and_fro),
                       share_to_and_fro, 1.0);
  const double most = most_acceleration * elapsed_s * elapsed_s;
  const double far = share * off.norm();
  if (far > most) share *= (most + share_beyond * (far - most)) / far;
  at = expected + share * off;
  speed += share_of_speed * share / elapsed_s * off;
  last_off = off;
}

}  // namespace abrazo
