#include "core/base/rotation.hpp"

namespace abrazo {

Eigen::Quaterniond smallest_rotation(const Vec3& from, const Vec3& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to);
}

}  // namespace abrazo
