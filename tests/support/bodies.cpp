#include "tests/support/bodies.hpp"

#include <Eigen/Geometry>

namespace abrazo::test {

Pose standing_pose() {
  Pose pose;
  pose << 0, 0.95, 0,                                                                            // root
      0.10, 0.87, 0.01, 0.11, 0.47, 0.03, 0.12, 0.09, 0.00, 0.13, 0.04, 0.12, 0.13, 0.03, 0.19,  // left leg
      -0.10, 0.87, 0.01, -0.11, 0.47, 0.03, -0.12, 0.09, 0.00, -0.13, 0.04, 0.12, -0.13, 0.03, 0.19, 0, 1.06,
      -0.01, 0.001, 1.17, -0.02, 0, 1.29, -0.02,                                // spine
      0.002, 1.40, -0.02, 0, 1.48, 0.0, 0, 1.60, 0.01,                          // neck, head
      0.19, 1.37, -0.02, 0.30, 1.12, 0.03, 0.31, 0.98, 0.24, 0.31, 0.96, 0.32,  // left arm
      -0.19, 1.37, -0.02, -0.30, 1.12, 0.03, -0.31, 0.98, 0.24, -0.31, 0.96, 0.32;
  return pose;
}

Pose moved(const Pose& pose, double yaw_rad, const Vec3& offset) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(yaw_rad, Vec3::UnitY()).toRotationMatrix();
  Pose result = pose * turn.transpose();
  result.rowwise() += offset.transpose();
  return result;
}

Pose shaken(const Pose& pose, double sigma_m, std::mt19937& random) {
  std::normal_distribution<double> error(0.0, sigma_m);
  Pose result = pose;
  for (int r = 0; r < joint_count; ++r)
    for (int c = 0; c < 3; ++c) result(r, c) += error(random);
  return result;
}

PairPose facing_pair(double distance_m) {
  PairPose pair;
  pair.topRows<joint_count>() = standing_pose();
  pair.bottomRows<joint_count>() = moved(standing_pose(), 3.14159265358979, Vec3(0, 0, distance_m));
  return pair;
}

}  // namespace abrazo::test
