#pragma once

#include <numeric>
#include <vector>

namespace abrazo {

/// 0 for none.
inline double mean(const std::vector<double>& values) {
  if (values.empty()) return 0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace abrazo
