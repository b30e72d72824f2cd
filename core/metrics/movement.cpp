#include "core/metrics/movement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/statistics.hpp"

namespace abrazo {

std::optional<MovementStep> MovementSteps::next(const Pose& pose, double time_s) {
  const double elapsed_s = time_s - time_s_;
  if (pose_ && !(elapsed_s > 0)) interrupt();
  std::optional<MovementStep> step;
  if (pose_) {
    const Velocity velocity{(pose - *pose_) / elapsed_s, elapsed_s};
    step.emplace();
    step->speed_m_s = velocity.m_s.rowwise().norm().mean();
    step->length_m = step->speed_m_s * elapsed_s;
    step->slide_m_s = landed_foot_speeds(*pose_, pose, elapsed_s, rest_);
    if (velocity_) {
      const Pose change_m_s = velocity.m_s - velocity_->m_s;
      const double across_s = 0.5 * (velocity_->elapsed_s + elapsed_s);
      step->acceleration_m_s2 = std::sqrt(change_m_s.squaredNorm() / joint_count) / across_s;
      step->unexplained_m = change_m_s.rowwise().norm().mean() * elapsed_s;
    }
    velocity_ = velocity;
  }
  pose_ = pose;
  time_s_ = time_s;
  return step;
}

void MovementSteps::interrupt() {
  pose_.reset();
  velocity_.reset();
}

std::optional<MovementStep> MovementMetric::add(const Pose& pose, double time_s) {
  const std::optional<MovementStep> step = steps_.next(pose, time_s);
  if (!step) return step;
  speeds_m_s_.push_back(step->speed_m_s);
  largest_step_m_ = std::max(largest_step_m_, step->length_m);
  if (step->acceleration_m_s2) accelerations_m_s2_.push_back(*step->acceleration_m_s2);
  slide_.add(step->slide_m_s);
  return step;
}

MovementMetric::Figures MovementMetric::figures() const {
  Figures f;
  f.speed_p50_m_s = quantile(speeds_m_s_, 0.5);
  f.speed_p99_m_s = quantile(speeds_m_s_, 0.99);
  f.speed_rms_m_s = root_mean_square(speeds_m_s_);
  f.acceleration_p50_m_s2 = quantile(accelerations_m_s2_, 0.5);
  f.acceleration_p99_m_s2 = quantile(accelerations_m_s2_, 0.99);
  f.acceleration_rms_m_s2 = root_mean_square(accelerations_m_s2_);
  f.largest_step_m = speeds_m_s_.empty() ? std::numeric_limits<double>::quiet_NaN() : largest_step_m_;
  f.slide = slide_.figures();
  return f;
}

}  // namespace abrazo
