#include "core/synthesis/motion/body_shape.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace abrazo {

namespace {
constexpr double smallest_m = 1e-6;
constexpr double smallest_turn = 1e-9;
}  // namespace

BodyShape shape_of(const Pose& own, double root_height) {
  BodyShape shape;
  for (int b = 0; b < bone_count; ++b) {
    const auto [from, to] = bone(b);
    const Vec3 along = own.row(to) - own.row(from);
    const double length = along.norm();
    shape.directions[static_cast<std::size_t>(b)] = length > smallest_m ? Vec3(along / length) : Vec3::Zero();
  }
  shape.root_height = root_height;
  return shape;
}

Pose placed_body(const BodyShape& shape, const Body& body, const RootFrame& place) {
  const Eigen::Matrix3d rotation = place.rotation();
  Pose pose;
  pose.row(0) = Eigen::RowVector3d(place.position.x(), shape.root_height, place.position.z());
  for (int b = 0; b < bone_count; ++b) {
    const auto [from, to] = bone(b);
    const auto at = static_cast<std::size_t>(b);
    pose.row(to) = pose.row(from) + body.bone_lengths[at] * (rotation * shape.directions[at]).transpose();
  }
  return pose;
}

Vec3 turn_between(const Vec3& from, const Vec3& to) {
  const Vec3 axis = from.cross(to);
  const double sine = axis.norm();
  const double cosine = from.dot(to);
  if (sine > smallest_turn) return std::atan2(sine, cosine) / sine * axis;
  if (cosine >= 0 || from.squaredNorm() < 0.5) return Vec3::Zero();
  return std::acos(-1.0) * from.unitOrthogonal();  // opposite: any axis will do
}

Vec3 turned(const Vec3& vector, const Vec3& turn) {
  const double angle = turn.norm();
  if (angle < smallest_turn) return vector;
  return Eigen::AngleAxisd(angle, turn / angle) * vector;
}

}  // namespace abrazo
