#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "core/metrics/run_comparison.hpp"
#include "widgets/common/value_range.hpp"

namespace abrazo::widgets {

/// Mapping of seconds and values to a curve's rectangle [pixels].
struct CurveScale {
  double left = 0, top = 0, width = 1, height = 1;
  double first_s = 0, last_s = 1;
  double upper = 1;  ///< value at the top; 0 is at the bottom

  double x(double time_s) const {
    return last_s > first_s ? left + width * (time_s - first_s) / (last_s - first_s) : left;
  }
  double y(double value) const { return top + height * (1 - std::clamp(value / upper, 0.0, 1.0)); }
  double time(double at_x) const {
    return first_s + (last_s - first_s) * std::clamp((at_x - left) / width, 0.0, 1.0);
  }
};

/// Top of the scale for a figure of both runs, in the displayed unit; 1 without values.
inline double curve_upper(std::span<const ComparedStep> steps, StepFigure figure) {
  const auto at = static_cast<std::size_t>(figure);
  std::vector<double> values;
  for (const ComparedStep& step : steps) {
    values.push_back(info_of(figure).scale * step.a[at]);
    values.push_back(info_of(figure).scale * step.b[at]);
  }
  const double upper = robust_upper(std::move(values));
  return upper > 0 ? rounded_up(upper) : 1;
}

/// The step shown at a time: the last not after it; the first if all are later; -1 without steps.
inline std::ptrdiff_t step_at(std::span<const ComparedStep> steps, double time_s) {
  const auto after =
      std::upper_bound(steps.begin(), steps.end(), time_s,
                       [](double time, const ComparedStep& step) { return time < step.time_s; });
  return std::max<std::ptrdiff_t>(after - steps.begin() - 1, steps.empty() ? -1 : 0);
}

}  // namespace abrazo::widgets
