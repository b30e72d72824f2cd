#include "core/metrics/continuity.hpp"

#include "core/base/statistics.hpp"
#include "core/metrics/partner_error.hpp"

namespace abrazo {

void ContinuityMetric::add(const Pose& partner, bool source_changed) {
  ++steps_;
  source_changes_ += source_changed;
  if (!recent_.empty()) displacements_m_.push_back(mean_joint_distance(partner, recent_.back()));
  if (recent_.size() == 2) {
    const Pose straight_on = 2 * recent_.back() - recent_.front();
    second_differences_m_.push_back(mean_joint_distance(partner, straight_on));
    recent_.erase(recent_.begin());
  }
  recent_.push_back(partner);
}

void ContinuityMetric::interrupt() {
  recent_.clear();
}

ContinuityMetric::Figures ContinuityMetric::figures() const {
  Figures f;
  f.steps = steps_;
  f.displacement_mean_m = mean(displacements_m_);
  f.displacement_p95_m = percentile(displacements_m_, 0.95);
  f.displacement_p99_m = percentile(displacements_m_, 0.99);
  f.displacement_max_m = percentile(displacements_m_, 1);
  f.second_difference_mean_m = mean(second_differences_m_);
  f.second_difference_p99_m = percentile(second_differences_m_, 0.99);
  if (steps_ > 0) f.source_changes_per_100 = 100.0 * source_changes_ / steps_;
  return f;
}

}  // namespace abrazo
