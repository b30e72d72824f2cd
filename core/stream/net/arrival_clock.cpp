#include "core/stream/net/arrival_clock.hpp"

#include <algorithm>
#include <cmath>

namespace abrazo {

namespace {

/// The first packet has no reference.
constexpr double oldest_first_s = 10;
/// A wall clock that follows a time server is at most so much faster or slower.
constexpr double fastest_slew = 1e-3;
/// Less is no more than the time between the readings of two clocks, and does a pose no harm.
constexpr double least_step_s = 0.02;

}  // namespace

double ArrivalClock::arrived_s(double stamp_s, double wall_s, double now_s) {
  const double ahead_s = wall_s - now_s;
  if (is_first_)
    set_s_ = now_s - oldest_first_s;
  else if (std::abs(ahead_s - ahead_s_) > least_step_s + fastest_slew * (now_s - read_s_))
    set_s_ = now_s;
  is_first_ = false;
  ahead_s_ = ahead_s;
  read_s_ = now_s;
  const double arrived_s = stamp_s - ahead_s;
  return arrived_s < set_s_ ? now_s : std::min(arrived_s, now_s);
}

}  // namespace abrazo
