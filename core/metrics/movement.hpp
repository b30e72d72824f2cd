#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/base/positions.hpp"
#include "core/metrics/foot_slide.hpp"

namespace abrazo {

/// What a body did from one pose to the next.
struct MovementStep {
  double length_m = 0;   ///< mean over the joints of their displacement
  double speed_m_s = 0;  ///< that by the time that passed
  /// Across the pose before: change of the joints' velocities by half the time from the pose before it to
  /// this one; root mean square over the joints. Nothing before the third pose without interruption.
  std::optional<double> acceleration_m_s2;
  /// Mean over the joints of the distance from where the velocities of the step before would have led.
  std::optional<double> unexplained_m;
  std::array<std::optional<double>, 2> slide_m_s;  ///< of landed toe bases: left, right
};

/// Takes poses as they come and says what each step was.
class MovementSteps {
 public:
  explicit MovementSteps(const ToeRest& rest) : rest_(rest) {}

  /// @param time_s  of the pose; one that is not later than that of the pose before interrupts
  /// @return nothing for the first pose, also after an interruption
  std::optional<MovementStep> next(const Pose& pose, double time_s);
  /// The next pose is not compared with the last: a step failed, or another take begins.
  void interrupt();

 private:
  struct Velocity {
    Pose m_s;
    double elapsed_s;
  };
  ToeRest rest_;
  std::optional<Pose> pose_;  ///< the last one
  double time_s_ = 0;
  std::optional<Velocity> velocity_;  ///< of the step that led to it
};

/// How a body moves: how fast, how hard it is accelerated, how its landed feet slide. The same for a capture
/// and for what was made of it, so that the two can be put beside one another; in seconds, so that runs of
/// other step rates can.
class MovementMetric {
 public:
  explicit MovementMetric(const ToeRest& rest) : steps_(rest) {}

  /// @see MovementSteps::next
  std::optional<MovementStep> add(const Pose& pose, double time_s);
  void interrupt() { steps_.interrupt(); }

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

 private:
  MovementSteps steps_;
  std::vector<double> speeds_m_s_, accelerations_m_s2_;
  double largest_step_m_ = 0;
  FootSlideMetric slide_;
};

}  // namespace abrazo
