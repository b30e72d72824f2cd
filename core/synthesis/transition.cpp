#include "core/synthesis/transition.hpp"

#include <cmath>

namespace abrazo {

namespace {
constexpr double half_life_product = 1.6783469900166605;  ///< (1 + x) exp(-x) = 1/2
}

void Transition::reset() {
  *this = Transition();
}

void Transition::fade(double elapsed_s, double half_life_s, const std::array<double, joint_count>& hurry) {
  if (half_life_s <= 0) return reset();
  for (int joint = 0; joint < joint_count; ++joint) {
    // x(t) = (x0 + (v0 + y x0) t) exp(-y t). From rest half is left when (1 + y t) exp(-y t) = 1/2.
    const double y = half_life_product * hurry[static_cast<std::size_t>(joint)] / half_life_s;
    const double shrink = std::exp(-y * elapsed_s);
    const Eigen::RowVector3d slope = velocity_.row(joint) + y * offset_.row(joint);
    offset_.row(joint) = shrink * (offset_.row(joint) + elapsed_s * slope);
    velocity_.row(joint) = shrink * (velocity_.row(joint) - y * elapsed_s * slope);
  }
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
