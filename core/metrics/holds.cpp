#include "core/metrics/holds.hpp"

#include <cmath>
#include <limits>

#include "core/base/statistics.hpp"

namespace abrazo {

void HoldMetric::add(const PairPose& result, const PairPose& reference) {
  for (const HandEnds& hands : all_hand_ends) {
    const double recorded = hands_apart(reference, hands);
    const double shown = hands_apart(result, hands);
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

double hold_change_m(const PairPose& result, const PairPose& reference) {
  HoldMetric holds;
  holds.add(result, reference);
  const HoldMetric::Figures figures = holds.figures();
  return figures.holds > 0 ? figures.change_mean_m : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace abrazo
