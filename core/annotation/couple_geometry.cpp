#include "core/annotation/couple_geometry.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/motion/body/joint_set.hpp"

namespace abrazo {

namespace {

constexpr double full_turn_rad = 2 * std::numbers::pi;

/// Adds whole turns so that no step is longer than half a turn.
void unwrap(std::vector<double>& turns) {
  for (std::size_t i = 1; i < turns.size(); ++i)
    turns[i] = turns[i - 1] + std::remainder(turns[i] - turns[i - 1], 1.0);
}

/// Mean of each value with its two neighbours.
std::vector<double> smoothed(const std::vector<double>& values) {
  std::vector<double> result = values;
  for (std::size_t i = 1; i + 1 < values.size(); ++i)
    result[i] = (values[i - 1] + values[i] + values[i + 1]) / 3;
  return result;
}

std::vector<double> headings(const std::vector<Pose>& poses) {
  std::vector<double> turns;
  turns.reserve(poses.size());
  std::optional<double> before;
  for (const Pose& pose : poses) {
    before = root_frame(pose, before).heading_rad;
    turns.push_back(*before / full_turn_rad);
  }
  unwrap(turns);
  return smoothed(turns);
}

}  // namespace

CoupleMotion couple_motion(const MotionLibrary& library, int take, double rate_hz) {
  CoupleMotion motion;
  const LibraryTake& of = library.takes()[static_cast<std::size_t>(take)];
  const double library_hz = of.fps / of.frame_stride;
  const int step = of.frame_stride * std::max(1, static_cast<int>(std::lround(library_hz / rate_hz)));
  motion.fps = of.fps / step;
  for (int pair = 0; pair < library.pair_count(); ++pair) {
    const PairSource& source = library.source(pair);
    const int frame = static_cast<int>(source.frame);
    if (source.take != static_cast<std::uint32_t>(take) || frame % step != 0) continue;
    motion.frames.push_back(frame);
  }
  std::sort(motion.frames.begin(), motion.frames.end());
  motion.frames.erase(std::unique(motion.frames.begin(), motion.frames.end()), motion.frames.end());
  for (const int frame : motion.frames) {
    int pair = library.find_pair(of.name, frame, false);
    if (pair < 0) pair = library.find_pair(of.name, frame, true);
    const RootFrame& root = library.root(pair);
    Pose active = to_world(library.pose(pair).topRows<joint_count>(), root);
    Pose passive = to_world(library.pose(pair).bottomRows<joint_count>(), root);
    if (library.source(pair).swapped != library.columns().roles_exchanged) std::swap(active, passive);
    motion.a.push_back(active);
    motion.b.push_back(passive);
  }
  return motion;
}

CoupleGeometry couple_geometry(const CoupleMotion& motion) {
  CoupleGeometry geometry{headings(motion.a), headings(motion.b), {}};
  geometry.orb.reserve(motion.a.size());
  for (std::size_t i = 0; i < motion.a.size(); ++i) {
    const Vec3 line = (motion.b[i].row(joints::Root) - motion.a[i].row(joints::Root)).transpose();
    geometry.orb.push_back(std::atan2(line.x(), line.z()) / full_turn_rad);
  }
  unwrap(geometry.orb);
  return geometry;
}

double hand_distance(const Pose& mine, const Pose& yours, HandPair hands) {
  const bool my_left = hands == HandPair::LeftRight || hands == HandPair::LeftLeft;
  const bool your_left = hands == HandPair::RightLeft || hands == HandPair::LeftLeft;
  return (mine.row(my_left ? joints::left_hand : joints::right_hand) -
          yours.row(your_left ? joints::left_hand : joints::right_hand))
      .norm();
}

double back_distance(const Vec3& hand, const Pose& other) {
  const Vec3 to_left = (other.row(joints::left_shoulder) - other.row(joints::right_shoulder)).transpose();
  const Vec3 forward = to_left.cross(Vec3::UnitY());
  if ((hand - other.row(joints::Thorax).transpose()).dot(forward) >= 0) return far_m;
  double nearest = far_m;
  for (const int spine : {joints::LowerBack, joints::UpperBack, joints::Thorax})
    nearest = std::min(nearest, (hand - other.row(spine).transpose()).norm());
  return nearest;
}

}  // namespace abrazo
