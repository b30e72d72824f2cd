#include "core/motion/scenes/limb_reach.hpp"

#include <algorithm>
#include <cmath>

#include "core/motion/body/joint_rotations.hpp"

namespace abrazo {

namespace {

/// Share of the limb's length from which on the bend ends smoothly.
constexpr double straightens_at = 0.995;
/// Bend, as a sine, below which the plane of the limb is mostly that of before.
constexpr double faint_bend = 0.1;

}  // namespace

double LimbReach::bend_rad(double distance_m) const {
  const double longest = upper_m_ + lower_m_, shortest = std::abs(upper_m_ - lower_m_);
  const double soft = straightens_at * longest;
  double reached = std::max(distance_m, shortest);
  if (reached > soft) reached = soft + (longest - soft) * (1 - std::exp((soft - reached) / (longest - soft)));
  const double cosine =
      (reached * reached - upper_m_ * upper_m_ - lower_m_ * lower_m_) / (2 * upper_m_ * lower_m_);
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

LimbReach::Correction LimbReach::bring(const Vec3& upper, const Vec3& lower,
                                       const Eigen::Matrix3d& upper_rotation, const Vec3& to) {
  Correction none{Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Identity()};
  if (!(upper_m_ > 1e-6) || !(lower_m_ > 1e-6) || !(to.norm() > 1e-6)) return none;
  Vec3 axis = upper.cross(lower) + faint_bend * (upper_rotation * bend_);
  axis -= axis.dot(upper) * upper;
  if (axis.norm() < 1e-9) axis = upper.unitOrthogonal();
  axis.normalize();
  bend_ = upper_rotation.transpose() * axis;
  const Vec3 bent = Eigen::AngleAxisd(bend_rad(to.norm()), axis) * upper;
  const Vec3 end = upper_m_ * upper + lower_m_ * bent;
  if (end.norm() < 1e-6) return none;
  const Eigen::Matrix3d turn = swing(end.normalized(), to.normalized());
  return {turn, turn * swing(lower, bent)};
}

}  // namespace abrazo
