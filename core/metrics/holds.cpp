#include "core/metrics/holds.hpp"

#include <cmath>

#include "core/base/statistics.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {

void HoldMetric::add(const PairPose& result, const PairPose& reference) {
  for (const int active : {joints::left_hand, joints::right_hand})
    for (const int passive : {joints::left_hand, joints::right_hand}) {
      const auto apart = [&](const PairPose& pair) {
        return (pair.row(active) - pair.row(passive + joint_count)).norm();
      };
      const double recorded = apart(reference);
      const double shown = apart(result);
      if (recorded < hold_distance_m) {
        changes_m_.push_back(std::abs(shown - recorded));
        distances_m_.push_back(shown);
        kept_ += shown < still_held_m_;
        recalled_ += shown < hold_distance_m;
      }
      if (shown < hold_distance_m) {
        ++shown_;
        shown_and_recorded_ += recorded < still_held_m_;
      }
    }
}

HoldMetric::Figures HoldMetric::figures() const {
  Figures f;
  f.holds = static_cast<int>(changes_m_.size());
  f.shown_holds = shown_;
  f.change_mean_m = mean(changes_m_);
  f.change_p95_m = percentile(changes_m_, 0.95);
  f.distance_mean_m = mean(distances_m_);
  if (f.holds > 0) f.kept = static_cast<double>(kept_) / f.holds;
  if (f.holds > 0) f.recall = static_cast<double>(recalled_) / f.holds;
  if (shown_ > 0) f.precision = static_cast<double>(shown_and_recorded_) / shown_;
  if (f.kept + f.precision > 0) f.f1 = 2 * f.kept * f.precision / (f.kept + f.precision);
  return f;
}

}  // namespace abrazo
