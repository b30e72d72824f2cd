#include "core/choreography/limb_ik.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace abrazo {

Vec3 middle_joint(const Vec3& base, const Vec3& end, double upper, double lower, const Vec3& pole) {
  const Vec3 limb = end - base;
  const double distance = limb.norm();
  if (distance > upper + lower || distance < std::abs(upper - lower) || distance == 0)
    throw std::invalid_argument("middle_joint: the limb cannot span this distance");
  const Vec3 along = limb / distance;
  const Vec3 aside = pole - pole.dot(along) * along;
  if (aside.norm() < 1e-9) throw std::invalid_argument("middle_joint: the pole runs along the limb");
  // Law of cosines: where the height of the triangle meets the line from base to end.
  const double foot = (distance * distance + upper * upper - lower * lower) / (2 * distance);
  const double height = std::sqrt(std::max(0.0, upper * upper - foot * foot));
  return base + foot * along + height * aside.normalized();
}

Vec3 within_reach(const Vec3& base, const Vec3& target, double limb_length) {
  const double soft = 0.93 * limb_length, hard = 0.98 * limb_length;
  const double fold_soft = 0.38 * limb_length, fold_hard = 0.30 * limb_length;
  const Vec3 limb = target - base;
  const double distance = limb.norm();
  if (distance < 1e-9) return base + fold_hard * Vec3::UnitZ();
  double reached = distance;
  if (distance > soft) reached = soft + (hard - soft) * (1 - std::exp(-(distance - soft) / (hard - soft)));
  if (distance < fold_soft)
    reached = fold_soft -
              (fold_soft - fold_hard) * (1 - std::exp(-(fold_soft - distance) / (fold_soft - fold_hard)));
  return base + limb * (reached / distance);
}

}  // namespace abrazo
