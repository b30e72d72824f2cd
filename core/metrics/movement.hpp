#pragma once

#include <optional>
#include <vector>

#include "core/base/positions.hpp"
#include "core/metrics/foot_slide.hpp"

namespace abrazo {

/// How a body moves: how fast, how hard it is accelerated, how its landed feet slide. The same for a capture
/// and for what was made of it, so that the two can be put beside one another; in seconds, so that runs of
/// other step rates can. Speed of a step: mean over the joints of their displacement by the time that passed.
/// Acceleration at a pose: change of the joints' velocities across it by half the time from the pose before
/// to the one after; root mean square over the joints.
class MovementMetric {
 public:
  explicit MovementMetric(const ToeRest& rest) : rest_(rest) {}

  /// @param time_s  of the pose; one that is not later than that of the pose before interrupts
  void add(const Pose& pose, double time_s);
  /// The next pose is not compared with the last: a step failed, or another take begins.
  void interrupt();

  /// Not a number where there was nothing to measure.
  struct Figures {
    double speed_p50_m_s = 0, speed_p99_m_s = 0, speed_rms_m_s = 0;
    double acceleration_p50_m_s2 = 0, acceleration_p99_m_s2 = 0;
    double acceleration_rms_m_s2 = 0;  ///< over joints and poses
    double largest_step_m = 0;         ///< mean over the joints
    FootSlideMetric::Figures slide;
  };
  Figures figures() const;

  const std::vector<double>& speeds_m_s() const { return speeds_m_s_; }
  const std::vector<double>& accelerations_m_s2() const { return accelerations_m_s2_; }
  const FootSlideMetric& slide() const { return slide_; }

  /// Mean over the joints of the distance of the last pose from where the velocities of the step before would
  /// have brought it [m]; nothing before the third pose without interruption.
  std::optional<double> unexplained_m() const { return unexplained_m_; }

 private:
  struct Step {
    Pose velocity_m_s;
    double elapsed_s;
  };
  ToeRest rest_;
  std::optional<Pose> pose_;  ///< the last one
  double time_s_ = 0;
  std::optional<Step> step_;  ///< that led to it
  std::optional<double> unexplained_m_;
  std::vector<double> speeds_m_s_, accelerations_m_s2_;
  double largest_step_m_ = 0;
  FootSlideMetric slide_;
};

}  // namespace abrazo
