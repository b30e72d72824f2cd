#include "core/motion/joints/marker_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace abrazo {

Eigen::Matrix3d pelvis_axes(const Vec3& left_front, const Vec3& right_front, const Vec3& back) {
  const Vec3 left = (left_front - right_front).normalized();
  const Vec3 forward = (left_front + right_front) / 2 - back;
  const Vec3 up = forward.cross(left).normalized();
  Eigen::Matrix3d axes;
  axes.col(0) = left;
  axes.col(1) = up;
  axes.col(2) = left.cross(up);
  return axes;
}

Vec3 hip_centre(double width_m, double depth_m, int side) {
  return {side * (0.33 * width_m + 0.0073), -0.30 * width_m - 0.0109, -0.24 * depth_m - 0.0099};
}

Vec3 chord_centre(const Vec3& joint_above, const Vec3& marker, const Vec3& inward, double distance_m) {
  const Vec3 limb = marker - joint_above;
  const double length = limb.norm();
  if (!(length > distance_m)) return marker;
  const Vec3 along = limb / length;
  const Vec3 across = inward - inward.dot(along) * along;
  if (!(across.norm() > 1e-9)) return marker;
  const double reach = std::sqrt(length * length - distance_m * distance_m);
  return joint_above + (reach * reach / length) * along + (distance_m * reach / length) * across.normalized();
}

Vec3 away_from(const Vec3& outer_marker, const Vec3& above, const Vec3& below) {
  const Vec3 limb = below - above;
  const double squared = limb.squaredNorm();
  if (!(squared > 0)) return Vec3::Zero();
  const Vec3 from_line = outer_marker - above - (outer_marker - above).dot(limb) / squared * limb;
  const double distance = from_line.norm();
  constexpr double clear_m = 0.03;
  return distance > 0 ? Vec3(-from_line / distance * std::min(1.0, distance / clear_m)) : Vec3(Vec3::Zero());
}

}  // namespace abrazo
