#include "core/metrics/penetration.hpp"

#include <algorithm>

#include "core/base/statistics.hpp"

namespace abrazo {

namespace {

constexpr double deep_m = 0.01;

double largest(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

}  // namespace

void PenetrationMetric::add(const PairPose& result, const PairPose& selected, const CapsuleRadii& active,
                            const CapsuleRadii& passive) {
  double deepest_m = 0, excess_m = 0;
  contacts_.prepare(selected, active, passive);
  contacts_.measure(result, overlaps_, deepest_m, excess_m);
  add(deepest_m, excess_m);
}

void PenetrationMetric::add(double deepest_m, double deepest_excess_m) {
  depths_m_.push_back(deepest_m);
  excesses_m_.push_back(deepest_excess_m);
}

PenetrationMetric::Figures PenetrationMetric::figures() const {
  Figures f;
  f.frames = static_cast<int>(depths_m_.size());
  if (f.frames == 0) return f;
  const auto deep = std::count_if(depths_m_.begin(), depths_m_.end(), [](double d) { return d > deep_m; });
  f.deep_share = static_cast<double>(deep) / f.frames;
  f.mean_m = mean(depths_m_);
  f.p99_m = percentile(depths_m_, 0.99);
  f.max_m = largest(depths_m_);
  f.excess_p99_m = percentile(excesses_m_, 0.99);
  f.excess_max_m = largest(excesses_m_);
  return f;
}

}  // namespace abrazo
