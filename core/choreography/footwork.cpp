#include "core/choreography/footwork.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/choreography/smooth_track.hpp"

namespace abrazo {

void Footwork::add(const FootMove& move) {
  if (move.end <= move.start) throw std::invalid_argument("a foot move must last some time");
  if (!moves_.empty() && move.start < moves_.back().end)
    throw std::invalid_argument("a foot move begins before the previous one has ended");
  moves_.push_back(move);
}

FootPosture Footwork::at(double beat) const {
  const auto next = std::upper_bound(moves_.begin(), moves_.end(), beat,
                                     [](double time, const FootMove& move) { return time < move.start; });
  if (next == moves_.begin()) return {.toe_base = start_.toe_base, .yaw = start_.yaw};
  const FootMove& move = *std::prev(next);
  const FootMove& before = std::prev(next) == moves_.begin() ? start_ : *std::prev(next, 2);
  if (beat >= move.end) return {.toe_base = move.toe_base, .yaw = move.yaw};
  const double u = (beat - move.start) / (move.end - move.start);
  const double done = minimum_jerk(u);
  // The heel leaves the floor first and comes down last but one: its bump is early, the lift's is centred.
  const double heel_bump = smooth_bump(std::pow(u, 0.8));
  FootPosture foot{.toe_base = before.toe_base + done * (move.toe_base - before.toe_base),
                   .yaw = std::lerp(before.yaw, move.yaw, done),
                   .heel_pitch = move.heel * heel_bump,
                   .toe_pitch = move.lift > 0 ? 0.6 * move.heel * smooth_bump(u) : 0};
  foot.toe_base += smooth_bump(u) * (move.detour + move.lift * Vec3::UnitY());
  return foot;
}

}  // namespace abrazo
