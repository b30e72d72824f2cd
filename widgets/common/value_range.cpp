#include "widgets/common/value_range.hpp"

namespace abrazo::widgets {

double rounded_up(double value) {
  if (!(value > 0) || !std::isfinite(value)) return 0;
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 1.5, 2.0, 3.0, 5.0, 7.5})
    if (value <= step * decade * (1 + 1e-9)) return step * decade;
  return 10 * decade;
}

void SteadyRange::show(double largest, double time_s) {
  constexpr double shrink_after_s = 1.5;
  if (locked_ && upper_ > 0) return;
  if (largest > upper_ || upper_ == 0) {
    upper_ = rounded_up(largest);
    is_low_ = false;
    return;
  }
  if (largest > 0.6 * upper_) {
    is_low_ = false;
  } else if (!is_low_ || time_s < low_since_s_) {
    is_low_ = true;
    low_since_s_ = time_s;
  } else if (time_s - low_since_s_ > shrink_after_s) {
    upper_ = rounded_up(largest);
    is_low_ = false;
  }
}

}  // namespace abrazo::widgets
