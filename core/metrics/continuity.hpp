#pragma once

#include <vector>

#include "core/base/positions.hpp"

namespace abrazo {

/// How smoothly the partner moves: mean over joints of the displacement from step to step and of its second
/// difference |p_t - 2 p_(t-1) + p_(t-2)|, and how often the recorded source changes. Figures are per step,
/// not per second: compare only runs of the same step rate.
class ContinuityMetric {
 public:
  void add(const Pose& partner, bool source_changed);
  /// Call between two takes and after a failed step: the next pose is not compared with the last.
  void interrupt();

  struct Figures {
    double displacement_mean_m = 0, displacement_p95_m = 0, displacement_p99_m = 0, displacement_max_m = 0;
    double second_difference_mean_m = 0, second_difference_p99_m = 0;
    double source_changes_per_100 = 0;  ///< per 100 steps
    int steps = 0;
  };
  Figures figures() const;

 private:
  std::vector<Pose> recent_;  ///< at most 2, the latest last
  std::vector<double> displacements_m_, second_differences_m_;
  int steps_ = 0, source_changes_ = 0;
};

}  // namespace abrazo
