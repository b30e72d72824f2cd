#include "tests/support/libraries.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "core/library/build/motion_library_builder.hpp"
#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::test {

namespace {

bool is_beyond(int joint, int root) {
  for (; joint > 0; joint = joint_parents[static_cast<std::size_t>(joint)])
    if (joint_parents[static_cast<std::size_t>(joint)] == root) return true;
  return false;
}

/// How a limb swings: angle = size * sin(2 pi rate t + phase).
struct Swing {
  int joint;
  Vec3 axis;
  double size_rad, rate_hz, phase_rad;
};

std::vector<Swing> random_swings(unsigned seed) {
  using namespace joints;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> size(0.05, 0.3), rate(0.3, 0.8), phase(0, 6.28);
  std::vector<Swing> swings;
  for (const int joint : {static_cast<int>(LowerBack), static_cast<int>(Thorax), left_shoulder, left_elbow,
                          right_shoulder, right_elbow, left_hip, right_hip})
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 0, 1)})
      swings.push_back({joint, axis, size(random), rate(random), phase(random)});
  return swings;
}

Pose swung(const std::vector<Swing>& swings, double time_s) {
  Pose pose = standing_pose();
  for (const Swing& swing : swings)
    pose = bent(pose, swing.joint,
                swing.size_rad * std::sin(2 * std::numbers::pi * swing.rate_hz * time_s + swing.phase_rad),
                swing.axis);
  return pose;
}

}  // namespace

Pose bent(const Pose& pose, int joint, double angle_rad, const Vec3& axis) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle_rad, axis.normalized()).toRotationMatrix();
  Pose result = pose;
  for (int other = 0; other < joint_count; ++other)
    if (is_beyond(other, joint))
      result.row(other) = pose.row(joint) + (pose.row(other) - pose.row(joint)) * turn.transpose();
  return result;
}

PairedTake swinging_take(const std::string& name, int frames, unsigned seed, double distance_m) {
  PairedTake take;
  take.name = name;
  take.roles = {{0, frames, ActivePerformer::A}};
  take.labels = {{0, frames / 2, "open_hold", "", ""}, {frames / 2, frames, "turn", "", ""}};
  const auto a = random_swings(2 * seed);
  const auto b = random_swings(2 * seed + 1);
  for (int frame = 0; frame < frames; ++frame) {
    const double t = frame / take.fps;
    take.a.poses.push_back(moved(swung(a, t), 0.2 * std::sin(0.7 * t), Vec3(0.1 * std::sin(t), 0, 0)));
    take.b.poses.push_back(
        moved(0.93 * swung(b, t), std::numbers::pi + 0.2 * std::sin(0.9 * t), Vec3(0, 0, distance_m)));
  }
  return take;
}

std::shared_ptr<const MotionLibrary> small_library() {
  std::vector<PairedTake> takes;
  takes.push_back(swinging_take("first", 180, 1));
  takes.push_back(swinging_take("second", 150, 2));
  auto library = build_library("small", std::move(takes), {}, {});
  return std::make_shared<const MotionLibrary>(std::move(*library));
}

}  // namespace abrazo::test
