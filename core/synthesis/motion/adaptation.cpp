#include "core/synthesis/motion/adaptation.hpp"

#include <cmath>

namespace abrazo {

Pose Adaptation::follow(const Pose& asked, const RootFrame& place, double elapsed_s, double rate) {
  const Eigen::Matrix3d rotation = place.rotation();
  const Pose wanted = asked * rotation;
  const Pose off = offset_ - wanted;
  const Pose slope = speed_ + rate * off;
  const double shrink = std::exp(-rate * elapsed_s);
  offset_ = wanted + shrink * (off + elapsed_s * slope);
  speed_ = shrink * (speed_ - (rate * elapsed_s) * slope);
  return offset_ * rotation.transpose();
}

}  // namespace abrazo
