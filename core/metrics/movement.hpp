#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/base/positions.hpp"
#include "core/metrics/foot_slide.hpp"

namespace abrazo {

/// Movement of a body from one pose to the next.
struct MovementStep {
  double length_m = 0;   ///< mean over the joints of their displacement
  double speed_m_s = 0;  ///< length per elapsed time
  /// Acceleration at the previous pose: change of the joints' velocities divided by half the time spanned by
  /// the three poses; root mean square over the joints. None before the third pose without interruption.
  std::optional<double> acceleration_m_s2;
  /// Mean over the joints of the distance from the position extrapolated with the previous step's velocities.
  std::optional<double> unexplained_m;
  std::array<std::optional<double>, 2> slide_m_s;  ///< of landed toe bases: left, right
};

/// Computes a MovementStep for each successive pose.
class MovementSteps {
 public:
  explicit MovementSteps(const ToeRest& rest) : rest_(rest) {}

  /// @param time_s of the pose; a time not later than the previous one interrupts
  /// @return none for the first pose and after an interruption
  std::optional<MovementStep> next(const Pose& pose, double time_s);
  /// The next pose is not compared with the last. Call after a failed step and before another take.
  void interrupt();

 private:
  struct Velocity {
    Pose m_s;
    double elapsed_s;
  };
  ToeRest rest_;
  std::optional<Pose> pose_;  ///< the last one
  double time_s_ = 0;
  std::optional<Velocity> velocity_;  ///< of the step to that pose
};

/// Movement of a body: speed, acceleration, sliding of landed feet. The same figures apply to captures and
/// synthesised motion, so both can be compared; they are per second, so runs of different step rates can be
/// compared too.
class MovementMetric {
 public:
  explicit MovementMetric(const ToeRest& rest) : steps_(rest) {}

  /// @see MovementSteps::next
  std::optional<MovementStep> add(const Pose& pose, double time_s);
  void interrupt() { steps_.interrupt(); }

  /// NaN if there was nothing to measure.
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

 private:
  MovementSteps steps_;
  std::vector<double> speeds_m_s_, accelerations_m_s2_;
  double largest_step_m_ = 0;
  FootSlideMetric slide_;
};

}  // namespace abrazo
