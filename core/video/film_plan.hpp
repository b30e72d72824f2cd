#pragma once

#include <cmath>

namespace abrazo {

/// The times of the frames of a film: the beginning, then every 1 / rate seconds up to the end.
struct FilmPlan {
  static constexpr double slowest_hz = 1, fastest_hz = 240;
  double from_s = 0, to_s = 0;
  double rate_hz = 30;

  int pictures() const {
    constexpr double rounding = 1e-6;
    return to_s < from_s ? 0 : static_cast<int>(std::floor((to_s - from_s) * rate_hz + rounding)) + 1;
  }
  double time_of(int picture) const { return from_s + picture / rate_hz; }
};

}  // namespace abrazo
