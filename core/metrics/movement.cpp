#include "core/metrics/movement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/statistics.hpp"

namespace abrazo {

void MovementMetric::add(const Pose& pose, double time_s) {
  unexplained_m_.reset();
  const double elapsed_s = time_s - time_s_;
  if (pose_ && !(elapsed_s > 0)) interrupt();
  if (pose_) {
    const Step step{(pose - *pose_) / elapsed_s, elapsed_s};
    const double speed_m_s = step.velocity_m_s.rowwise().norm().mean();
    speeds_m_s_.push_back(speed_m_s);
    largest_step_m_ = std::max(largest_step_m_, speed_m_s * elapsed_s);
    slide_.add(*pose_, pose, elapsed_s, rest_);
    if (step_) {
      const Pose change_m_s = step.velocity_m_s - step_->velocity_m_s;
      const double across_s = 0.5 * (step_->elapsed_s + elapsed_s);
      accelerations_m_s2_.push_back(std::sqrt(change_m_s.squaredNorm() / joint_count) / across_s);
      unexplained_m_ = change_m_s.rowwise().norm().mean() * elapsed_s;
    }
    step_ = step;
  }
  pose_ = pose;
  time_s_ = time_s;
}

void MovementMetric::interrupt() {
  pose_.reset();
  step_.reset();
  unexplained_m_.reset();
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
