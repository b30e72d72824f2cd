#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace abrazo {

/// Hann-weighted mean over `half_width` values to either side; constant beyond the ends.
template <typename Value>
std::vector<Value> hann_mean(const std::vector<Value>& values, int half_width) {
  std::vector<double> weights;
  double total = 0;
  for (int k = -half_width; k <= half_width; ++k) {
    weights.push_back(1 + std::cos(std::numbers::pi * k / (half_width + 1)));
    total += weights.back();
  }
  const int last = static_cast<int>(values.size()) - 1;
  std::vector<Value> means;
  means.reserve(values.size());
  for (int i = 0; i <= last; ++i) {
    Value sum = values[static_cast<std::size_t>(i)] * 0.0;
    for (int k = -half_width; k <= half_width; ++k)
      sum += weights[static_cast<std::size_t>(k + half_width)] *
             values[static_cast<std::size_t>(std::clamp(i + k, 0, last))];
    means.push_back(sum / total);
  }
  return means;
}

/// The largest of `half_width` values to either side.
inline std::vector<double> moving_maximum(const std::vector<double>& values, int half_width) {
  const int last = static_cast<int>(values.size()) - 1;
  std::vector<double> highest(values);
  for (int i = 0; i <= last; ++i)
    for (int k = std::max(0, i - half_width); k <= std::min(last, i + half_width); ++k)
      highest[static_cast<std::size_t>(i)] =
          std::max(highest[static_cast<std::size_t>(i)], values[static_cast<std::size_t>(k)]);
  return highest;
}

}  // namespace abrazo
