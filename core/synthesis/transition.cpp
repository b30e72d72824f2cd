#include "core/synthesis/transition.hpp"

#include <cmath>

namespace abrazo {

void Transition::reset() {
  *this = Transition();
}

void Transition::fade(double elapsed_s, double half_life_s) {
  if (half_life_s <= 0) return reset();
  // x(t) = (x0 + (v0 + y x0) t) exp(-y t), with y such that a spring at rest has lost half after about the
  // half-life.
  const double y = 2.0 * std::log(2.0) / half_life_s;
  const double shrink = std::exp(-y * elapsed_s);
  const Pose slope = velocity_ + y * offset_;
  offset_ = shrink * (offset_ + elapsed_s * slope);
  velocity_ = shrink * (velocity_ - y * elapsed_s * slope);
}

void Transition::jump(const Pose& continued, const Pose& continued_velocity, const Pose& chosen,
                      const Pose& chosen_velocity) {
  offset_ += continued - chosen;
  velocity_ += continued_velocity - chosen_velocity;
}

void Transition::pull(int joint, const Vec3& seen, const Vec3& reference) {
  offset_.row(joint) = (seen - reference).transpose();
  velocity_.row(joint).setZero();
}

}  // namespace abrazo
