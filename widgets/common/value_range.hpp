#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace abrazo::widgets {

/// Upper end of a plot for these values: the largest, unless a few outliers exceed the rest; these are cut.
/// Ignores values that are not finite. @return 0 without values
inline double robust_upper(std::vector<double> values) {
  constexpr double usual_share = 0.98, towering = 1.8, room = 1.25;
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  if (values.empty()) return 0;
  const auto place = static_cast<std::ptrdiff_t>(usual_share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  const double usual = values[static_cast<std::size_t>(place)];
  const double largest = *std::max_element(values.begin() + place, values.end());
  return usual > 0 && largest > towering * usual ? room * usual : largest;
}

/// Stable ends of a colour range: the upper one has round numbers; grows immediately, shrinks only after
/// values stayed below 60 % of it for a while.
class SteadyRange {
 public:
  void show(double largest, double time_s);
  double upper() const { return upper_; }
  /// 0 unless set.
  double lower() const { return lower_; }
  /// A range that adapts begins at 0.
  void set_locked(bool locked) {
    locked_ = locked;
    if (!locked) lower_ = 0;
  }
  /// Sets and keeps both ends. @param lower  below `upper`
  void fix(double lower, double upper) {
    lower_ = lower;
    upper_ = upper;
    locked_ = true;
  }
  bool locked() const { return locked_; }
  /// Both adapt, or keep the same ends.
  bool has_ends_of(const SteadyRange& other) const {
    if (locked_ != other.locked_) return false;
    return !locked_ || (lower_ == other.lower_ && upper_ == other.upper_);
  }
  void reset() { upper_ = 0; }

 private:
  double upper_ = 0, lower_ = 0;
  double low_since_s_ = 0;
  bool is_low_ = false;
  bool locked_ = false;
};

/// The next of 1, 1.5, 2, 3, 5, 7.5 times a power of ten.
double rounded_up(double value);

}  // namespace abrazo::widgets
