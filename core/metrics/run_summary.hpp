#pragma once

#include <string>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/metrics/continuity.hpp"
#include "core/metrics/holds.hpp"
#include "core/metrics/motion_quality.hpp"
#include "core/metrics/penetration.hpp"
#include "core/synthesis/frames/frame_result.hpp"
#include "core/synthesis/settings/settings.hpp"

namespace abrazo {

/// Summary of a run: figures for constraints, motion and speed.
class RunSummary {
 public:
  /// @param user_role  the other role is the partner's
  explicit RunSummary(const MotionLibrary& library, UserRole user_role = UserRole::Active);

  void add(const FrameResult& frame, double time_s);
  /// Declares that the next frame does not follow the last.
  void interrupt();

  struct Figures {
    std::size_t frames = 0, relaxed = 0, failed = 0;
    double solve_us_p50 = 0, solve_us_p99 = 0;  ///< whole step, failed ones included
    double bone_length_max = 0;                 ///< relative
    double foot_lock_drift_max_m = 0;
    double excess_penetration_p99_m = 0;
    std::size_t holds = 0;          ///< hand pairs within 13 cm in the selected pairs
    double hold_change_mean_m = 0;  ///< |distance in the result - in the selected pair|
    double source_changes_per_100 = 0;
    double partner_displacement_mean_m = 0;  ///< of a joint, from step to step
    double partner_displacement_p99_m = 0;   ///< of the mean over joints
    double behind_selected_mean_m = 0;       ///< distance of the partner's joints from the selected pair
    double morph_rms_m = 0;
    MotionQuality::Figures motion;  ///< of the partner; rest heights are those of its body
  };
  Figures figures() const;

  /// The parts, for detailed reports.
  const HoldMetric& holds() const { return holds_; }
  const ContinuityMetric& continuity() const { return continuity_; }
  const PenetrationMetric& penetration() const { return penetration_; }

  std::string text(double step_rate_hz) const;
  std::string json(double step_rate_hz) const;

 private:
  const MotionLibrary& library_;
  bool partner_is_active_;
  MotionQuality motion_;
  std::size_t frames_ = 0, relaxed_ = 0, failed_ = 0;
  HoldMetric holds_;
  ContinuityMetric continuity_;
  PenetrationMetric penetration_;
  double bone_length_max_ = 0, foot_lock_drift_max_m_ = 0;
  std::vector<double> total_us_, behind_m_, morph_rms_m_;
};

}  // namespace abrazo
