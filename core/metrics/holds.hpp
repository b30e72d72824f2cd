#pragma once

#include <vector>

#include "core/base/positions.hpp"
#include "core/mesh/capsules.hpp"

namespace abrazo {

/// How well holds of a reference (the selected pair or the capture) are preserved in the result. A hold: hand
/// ends of different bodies within `hold_distance_m` (13 cm).
class HoldMetric {
 public:
  /// A hold of the selected pair may open by 3 cm before it counts as lost.
  static constexpr double selected_hold_kept_m = hold_distance_m + 0.03;
  /// A hold of the capture counts as held within 20 cm, because partner and hands are at other places.
  static constexpr double captured_hold_held_m = 0.20;

  explicit HoldMetric(double still_held_m = selected_hold_kept_m) : still_held_m_(still_held_m) {}

  void add(const PairPose& result, const PairPose& reference);

  struct Figures {
    int holds = 0;             ///< in the reference
    int shown_holds = 0;       ///< in the results
    double change_mean_m = 0;  ///< |distance in the result - in the reference| over `holds`
    double change_p95_m = 0;
    double distance_mean_m = 0;  ///< in the result, over `holds`
    double kept = 0;             ///< share of `holds` that are still held in the result
    double recall = 0;           ///< share of `holds` that are holds of the result too
    double precision = 0;        ///< share of `shown_holds` that are still held in the reference
    double f1 = 0;               ///< harmonic mean of `kept` and `precision`
  };
  /// Shares are 0 if the count beside them is 0.
  Figures figures() const;

 private:
  double still_held_m_;
  std::vector<double> changes_m_, distances_m_;
  int kept_ = 0, recalled_ = 0, shown_ = 0, shown_and_recorded_ = 0;
};

/// `change_mean_m` of one pair alone; NaN without a hold in the reference.
double hold_change_m(const PairPose& result, const PairPose& reference);

}  // namespace abrazo
