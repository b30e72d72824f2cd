#include <algorithm>

#include "core/video/video_frame.hpp"

namespace abrazo {

double VideoFacts::duration_s() const {
  if (times_s.empty()) return 0;
  return times_s.back() + (rate_hz > 0 ? 1 / rate_hz : 0);
}

int VideoFacts::index_at(double time_s) const {
  constexpr double rounding_s = 1e-6;
  const auto after = std::upper_bound(times_s.begin(), times_s.end(), time_s + rounding_s);
  return std::max(0, static_cast<int>(after - times_s.begin()) - 1);
}

}  // namespace abrazo
