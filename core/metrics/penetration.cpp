#include "core/metrics/penetration.hpp"

#include <algorithm>

#include "core/base/statistics.hpp"

namespace abrazo {

namespace {

constexpr double deep_m = 0.01;

struct Depths {
  double deepest_m = 0, excess_m = 0;
};

Depths measure(const PairPose& pair, const PairPose& reference, const CapsuleRadii& active,
               const CapsuleRadii& passive, CapsuleContacts& contacts,
               std::vector<CapsuleContact>& overlaps) {
  Depths depths;
  contacts.prepare(reference, active, passive);
  contacts.measure(pair, overlaps, depths.deepest_m, depths.excess_m);
  return depths;
}

Depths measure(const PairPose& pair, const PairPose& reference, const CapsuleRadii& active,
               const CapsuleRadii& passive) {
  CapsuleContacts contacts;
  std::vector<CapsuleContact> overlaps;
  return measure(pair, reference, active, passive, contacts, overlaps);
}

double largest(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

}  // namespace

double deepest_penetration(const PairPose& pair, const PairPose& reference, const CapsuleRadii& active,
                           const CapsuleRadii& passive) {
  return measure(pair, reference, active, passive).deepest_m;
}

double deepest_excess_penetration(const PairPose& pair, const PairPose& reference, const CapsuleRadii& active,
                                  const CapsuleRadii& passive) {
  return measure(pair, reference, active, passive).excess_m;
}

void PenetrationMetric::add(const PairPose& result, const PairPose& selected, const CapsuleRadii& active,
                            const CapsuleRadii& passive) {
  const Depths depths = measure(result, selected, active, passive, contacts_, overlaps_);
  add(depths.deepest_m, depths.excess_m);
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
