#include "core/motion/body/body.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/statistics.hpp"

namespace abrazo {

namespace {

double length_of_bone(const Body& body, int joint) {
  return body.bone_lengths[static_cast<std::size_t>(joint - 1)];
}

double distance(const Pose& pose, std::pair<int, int> ends) {
  return (pose.row(ends.first) - pose.row(ends.second)).norm();
}

}  // namespace

double Body::leg_length() const {
  using namespace joints;
  return 0.5 * (length_of_bone(*this, LeftFemur) + length_of_bone(*this, LeftTibia) +
                length_of_bone(*this, RightFemur) + length_of_bone(*this, RightTibia));
}

double Body::height() const {
  using namespace joints;
  double spine = 0;
  for (const int joint : {LowerBack, UpperBack, Thorax, LowerNeck, UpperNeck, Head})
    spine += length_of_bone(*this, joint);
  const double hip_drop =
      0.7 * 0.5 * (length_of_bone(*this, LeftHipJoint) + length_of_bone(*this, RightHipJoint));
  const double ankle_height = 0.11 * leg_length();
  return ankle_height + leg_length() + hip_drop + spine;
}

Body body_of(const Pose& pose) {
  return body_of(std::span<const Pose>(&pose, 1));
}

Body body_of(std::span<const Pose> poses) {
  Body body;
  if (poses.empty()) return body;
  const std::size_t stride = std::max<std::size_t>(1, poses.size() / 2000);
  std::vector<double> values;
  const auto median_of = [&](std::pair<int, int> ends) {
    values.clear();
    for (std::size_t i = 0; i < poses.size(); i += stride) values.push_back(distance(poses[i], ends));
    return percentile(values, 0.5);
  };
  for (int b = 0; b < bone_count; ++b) body.bone_lengths[static_cast<std::size_t>(b)] = median_of(bone(b));
  for (std::size_t p = 0; p < pseudo_bones.size(); ++p) body.pseudo_lengths[p] = median_of(pseudo_bones[p]);
  values.clear();
  for (std::size_t i = 0; i < poses.size(); i += stride)
    for (const int toe : {joints::left_toe_base, joints::right_toe_base}) values.push_back(poses[i](toe, 1));
  body.toe_rest_height = percentile(values, 0.05);
  return body;
}

double largest_length_difference(const Body& a, const Body& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.bone_lengths.size(); ++i) {
    const double longer = std::max({a.bone_lengths[i], b.bone_lengths[i], 1e-9});
    largest = std::max(largest, std::abs(a.bone_lengths[i] - b.bone_lengths[i]) / longer);
  }
  return largest;
}

}  // namespace abrazo
