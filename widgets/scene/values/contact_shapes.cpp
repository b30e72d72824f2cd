#include "widgets/scene/values/contact_shapes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/mesh/capsules.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo::widgets {
namespace {

/// The bone that ends at a vertex.
int bone_of(const std::array<int, 2>& ends) {
  return std::max(ends[0], ends[1]) % joint_count - 1;
}

}  // namespace

std::vector<ContactLine> contact_lines(const FrameResult& frame) {
  std::vector<ContactLine> lines;
  lines.reserve(frame.collisions.size());
  const auto vertex = [&frame](int v) { return Vec3(frame.result.row(v).transpose()); };
  for (const CapsuleContact& contact : frame.collisions) {
    const Vec3 a0 = vertex(contact.a[0]), a1 = vertex(contact.a[1]), b0 = vertex(contact.b[0]),
               b1 = vertex(contact.b[1]);
    const SegmentApproach nearest = closest_points(a0, a1, b0, b1);
    lines.push_back(
        {a0 + nearest.s * (a1 - a0), b0 + nearest.t * (b1 - b0), contact.depth_m, contact.allowed_depth_m});
  }
  return lines;
}

std::array<std::vector<int>, 2> colliding_bones(const FrameResult& frame) {
  std::array<std::vector<int>, 2> bones;
  const auto add = [](std::vector<int>& to, int bone) {
    if (std::find(to.begin(), to.end(), bone) == to.end()) to.push_back(bone);
  };
  for (const CapsuleContact& contact : frame.collisions) {
    add(bones[0], bone_of(contact.a));
    add(bones[1], bone_of(contact.b));
  }
  for (auto& of : bones) std::sort(of.begin(), of.end());
  return bones;
}

std::vector<std::array<int, 2>> held_hands(const FrameResult& frame) {
  std::vector<std::array<int, 2>> holds;
  const PairPose& pair = frame.selected_pair;
  for (const HandEnds& hands : all_hand_ends)
    if (hands_hold(pair, hands)) holds.push_back({hands.active, hands.passive + joint_count});
  return holds;
}

std::vector<int> floor_contacts(const PairPose& pair) {
  std::vector<int> standing;
  for (const int body : {0, joint_count})
    for (const int toe :
         {joints::left_toe_base, joints::left_toe_tip, joints::right_toe_base, joints::right_toe_tip})
      if (pair(body + toe, 1) < floor_contact_m) standing.push_back(body + toe);
  return standing;
}

std::vector<Vec3> capsule_outline(const Vec3& a, const Vec3& b, double radius_m, const Vec3& direction) {
  constexpr int points_per_end = 9;
  constexpr double pi = 3.14159265358979323846;
  const Vec3 flat = (b - a) - (b - a).dot(direction) * direction;
  const bool at_the_eye = flat.norm() < 1e-6;
  const Vec3 along = at_the_eye ? Vec3(direction.unitOrthogonal()) : Vec3(flat.normalized());
  const Vec3 across = direction.cross(along);
  std::vector<Vec3> outline;
  for (const int end : {0, 1}) {
    const Vec3& centre = end == 0 ? b : a;
    for (int p = 0; p < points_per_end; ++p) {
      const double angle = pi * (end + static_cast<double>(p) / (points_per_end - 1));
      outline.emplace_back(centre + radius_m * (std::sin(angle) * along - std::cos(angle) * across));
    }
  }
  return outline;
}

std::string depth_text(double depth_m, double allowed_m) {
  std::array<char, 64> text{};
  if (allowed_m > 0.0005)
    std::snprintf(text.data(), text.size(), "%.0f mm (recorded %.0f)", 1000 * depth_m, 1000 * allowed_m);
  else
    std::snprintf(text.data(), text.size(), "%.0f mm", 1000 * depth_m);
  return text.data();
}

}  // namespace abrazo::widgets
