#include "core/metrics/bone_lengths.hpp"

#include <algorithm>
#include <cmath>

namespace abrazo {

BoneLengthError measure_bone_lengths(std::span<const Pose> poses, const Body& wanted) {
  constexpr double no_length_m = 1e-6;
  BoneLengthError error;
  double sum = 0;
  std::size_t bones = 0;
  for (const Pose& pose : poses)
    for (int b = 0; b < bone_count; ++b) {
      const double length = wanted.bone_lengths[static_cast<std::size_t>(b)];
      if (length < no_length_m) continue;
      const auto [from, to] = bone(b);
      const double relative = std::abs((pose.row(from) - pose.row(to)).norm() - length) / length;
      error.max = std::max(error.max, relative);
      sum += relative;
      ++bones;
    }
  if (bones > 0) error.mean = sum / static_cast<double>(bones);
  return error;
}

}  // namespace abrazo
