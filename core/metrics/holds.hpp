#pragma once

#include <vector>

#include "core/base/positions.hpp"

namespace abrazo {

/// Are hands that hold one another in the selected pair still together in the result? A hold: hand ends of
/// different bodies within `hold_distance_m` (13 cm).
class HoldMetric {
 public:
  void add(const PairPose& result, const PairPose& selected);

  struct Figures {
    int holds = 0;             ///< in the selected pairs
    int shown_holds = 0;       ///< in the results
    double change_mean_m = 0;  ///< |distance in the result - in the selected pair| over `holds`
    double change_p95_m = 0;
    double kept = 0;       ///< share of `holds` within 16 cm in the result (recall)
    double precision = 0;  ///< share of `shown_holds` that are within 16 cm in the selected pair
    double f1 = 0;         ///< harmonic mean of the two
  };
  /// Shares of nothing are 0: look at the counts beside them.
  Figures figures() const;

 private:
  std::vector<double> changes_m_;
  int kept_ = 0, shown_ = 0, shown_and_recorded_ = 0;
};

}  // namespace abrazo
