#include "tests/support/libraries.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "core/library/build/motion_library_builder.hpp"
#include "core/mesh/capsules.hpp"
#include "core/mesh/interaction_mesh.hpp"
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

namespace {

constexpr int pairs_per_take = 4;

void add_take(LibraryColumns& columns, const std::string& name, const std::string& label) {
  const auto take = static_cast<std::uint32_t>(columns.takes.size());
  LibraryTake about;
  about.name = name;
  about.frames = pairs_per_take;
  about.labels = {{0, pairs_per_take, label, "", ""}};
  columns.takes.push_back(about);
  for (std::uint32_t frame = 0; frame < pairs_per_take; ++frame) {
    const PairPose world = facing_pair(0.6 + 0.05 * frame);
    const RootFrame root = root_frame(world.topRows<joint_count>());
    PairPose pose;
    pose.topRows<joint_count>() = to_normalized(world.topRows<joint_count>(), root);
    pose.bottomRows<joint_count>() = to_normalized(world.bottomRows<joint_count>(), root);
    columns.sources.push_back({take, frame, false, ActivePerformer::A});
    columns.roots.push_back(root);
    columns.poses.push_back(pose);
    columns.features.push_back(pose_features(pose.topRows<joint_count>()));
    const InteractionMesh mesh = tetrahedralize(pose);
    columns.edges.insert(columns.edges.end(), mesh.edges.begin(), mesh.edges.end());
    columns.tetrahedra.insert(columns.tetrahedra.end(), mesh.tetrahedra.begin(), mesh.tetrahedra.end());
    columns.edge_offsets.push_back(columns.edges.size());
    columns.tetrahedron_offsets.push_back(columns.tetrahedra.size());
    columns.mesh_quality.push_back(0);
  }
}

}  // namespace

std::shared_ptr<const MotionLibrary> two_take_library() {
  LibraryColumns columns;
  columns.name = "small";
  LibraryBody body;
  body.name = "salsa_01/a";
  body.body = body_of(standing_pose());
  body.capsule_radii = generic_capsule_radii();
  columns.bodies = {body};
  columns.edge_offsets = std::vector<std::uint64_t>{0};
  columns.tetrahedron_offsets = std::vector<std::uint64_t>{0};
  add_take(columns, "salsa_01", "turn");
  add_take(columns, "salsa_02", "open_hold");
  return std::make_shared<const MotionLibrary>(std::move(columns));
}

}  // namespace abrazo::test
