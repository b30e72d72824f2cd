#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace abrazo::widgets {

/// Conversion between seconds and pixels. Independent of Qt.
struct TimelineAxis {
  double left_px = 0;
  double width_px = 100;
  double first_s = 0;  ///< at the left end
  double span_s = 35;  ///< over the whole width

  static constexpr double shortest_s = 0.1, longest_s = 7 * 86400;

  double last_s() const { return first_s + span_s; }
  double right_px() const { return left_px + width_px; }
  double x(double time_s) const { return left_px + (time_s - first_s) / span_s * width_px; }
  double time(double x_px) const { return first_s + (x_px - left_px) / width_px * span_s; }
  double seconds_per_pixel() const { return span_s / std::max(width_px, 1.0); }

  /// Scales the span by a factor about `fixed_s`.
  void zoom(double factor, double fixed_s) {
    const double wanted = std::clamp(span_s * factor, shortest_s, longest_s);
    first_s = fixed_s - (fixed_s - first_s) * wanted / span_s;
    span_s = wanted;
  }

  /// Shows [from, to] with a small margin at both ends.
  void show(double from_s, double to_s) {
    constexpr double room = 0.02;
    span_s = std::clamp((to_s - from_s) * (1 + 2 * room), shortest_s, longest_s);
    first_s = (from_s + to_s) / 2 - span_s / 2;
  }

  /// Shows the end of [first, last] at the right, with a small margin; the beginning at the left if all fits.
  void follow(double range_first_s, double range_last_s) {
    constexpr double room = 0.02;
    first_s = std::max(range_first_s, range_last_s - span_s * (1 - room));
  }

  /// Scrolls as little as possible to show the time; from far away, centres it.
  void reveal(double time_s) {
    constexpr double margin = 0.04;
    if (time_s < first_s - span_s || time_s > last_s() + span_s)
      first_s = time_s - span_s / 2;
    else if (time_s < first_s + margin * span_s)
      first_s = time_s - margin * span_s;
    else if (time_s > last_s() - margin * span_s)
      first_s = time_s - (1 - margin) * span_s;
  }

  /// Distance of labelled ticks: a round number of seconds, minutes or hours, at least `apart_px` apart.
  double tick_s(double apart_px) const {
    const double least = apart_px * seconds_per_pixel();
    for (const double step : {0.01, 0.02, 0.05,  0.1,   0.2,   0.5,    1.0,    2.0,    5.0,    10.0,   15.0,
                              30.0, 60.0, 120.0, 300.0, 600.0, 1200.0, 1800.0, 3600.0, 7200.0, 14400.0})
      if (step >= least) return step;
    return 86400;
  }

  /// Times of the labelled ticks that are in view.
  std::vector<double> ticks(double apart_px) const {
    const double step = tick_s(apart_px);
    std::vector<double> times;
    for (double n = std::ceil(first_s / step - 1e-9); n * step <= last_s() + 1e-9; ++n)
      times.push_back(n * step);
    return times;
  }
};

}  // namespace abrazo::widgets
