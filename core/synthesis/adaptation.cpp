#include "core/synthesis/adaptation.hpp"

#include <cmath>

namespace abrazo {

Pose Adaptation::follow(const Pose& asked, const RootFrame& place, const Transition& transition,
                        bool source_changed, double elapsed_s, double rate) {
  const Eigen::Matrix3d rotation = place.rotation();
  const Pose wanted = asked * rotation;
  if (source_changed) jump_ = goal_ - wanted;
  goal_ = wanted + transition.left() * jump_;
  const Pose off = offset_ - goal_;
  const Pose slope = speed_ + rate * off;
  const double shrink = std::exp(-rate * elapsed_s);
  offset_ = goal_ + shrink * (off + elapsed_s * slope);
  speed_ = shrink * (speed_ - (rate * elapsed_s) * slope);
  return offset_ * rotation.transpose();
}

}  // namespace abrazo
