#include "core/evaluation/plots/svg_axis.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace abrazo {

namespace {

constexpr double rounding = 1e-9;  ///< of a tick's distance: 0.3 must be a tick from 0.1 in steps of 0.1

/// The smallest of 1, 2, 5 times a power of ten that is not below `step`.
double round_step(double step) {
  const double power = std::pow(10, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= step * (1 - rounding)) return factor * power;
  return 10 * power;
}

}  // namespace

std::vector<double> linear_ticks(double low, double high, int count) {
  if (!(high > low) || count < 1) return {low};
  const double step = round_step((high - low) / count);
  std::vector<double> ticks;
  for (double index = std::ceil(low / step - rounding); index <= high / step + rounding; ++index)
    ticks.push_back(index * step);
  return ticks;
}

std::vector<double> logarithmic_ticks(double low, double high) {
  if (!(low > 0) || !(high >= low)) throw std::invalid_argument("a logarithmic axis needs 0 < low <= high");
  const bool fine = std::log10(high / low) < 2;
  std::vector<double> ticks;
  for (int power = static_cast<int>(std::floor(std::log10(low)));
       std::pow(10, power) <= high * (1 + rounding); ++power)
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double tick = factor * std::pow(10, power);
      if ((fine || factor == 1.0) && tick >= low * (1 - rounding) && tick <= high * (1 + rounding))
        ticks.push_back(tick);
    }
  return ticks;
}

AxisScale::AxisScale(const PlotAxis& axis, double low, double high, double begin, double end, int tick_count)
    : logarithmic_(axis.logarithmic),
      low_(axis.minimum.value_or(low)),
      high_(axis.maximum.value_or(high)),
      begin_(begin),
      end_(end) {
  if (logarithmic_ && !(low_ > 0)) throw std::invalid_argument("a logarithmic axis needs positive values");
  if (logarithmic_)
    widen_logarithmic(axis);
  else
    widen_linear(axis, tick_count);
}

void AxisScale::widen_linear(const PlotAxis& axis, int tick_count) {
  if (!(high_ > low_)) high_ = low_ + (low_ == 0 ? 1 : std::abs(low_));
  const double step = round_step((high_ - low_) / tick_count);
  if (!axis.minimum) low_ = step * std::floor(low_ / step + rounding);
  if (!axis.maximum) high_ = step * std::ceil(high_ / step - rounding);
  ticks_ = linear_ticks(low_, high_, tick_count);
}

void AxisScale::widen_logarithmic(const PlotAxis& axis) {
  if (!(high_ > low_)) high_ = 10 * low_;
  const double margin = std::pow(high_ / low_, 0.04);
  if (!axis.minimum) low_ /= margin;
  if (!axis.maximum) high_ *= margin;
  ticks_ = logarithmic_ticks(low_, high_);
}

double AxisScale::at(double value) const {
  const double fraction =
      logarithmic_ ? std::log(value / low_) / std::log(high_ / low_) : (value - low_) / (high_ - low_);
  return begin_ + fraction * (end_ - begin_);
}

}  // namespace abrazo
