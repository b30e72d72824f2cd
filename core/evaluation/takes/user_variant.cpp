#include "core/evaluation/takes/user_variant.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/choreography/random_source.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {

namespace {

/// Standard normal, by Box and Muller.
double normal(RandomSource& random) {
  const double radius = std::sqrt(-2 * std::log(1 - random.uniform(0, 1)));
  return radius * std::cos(random.uniform(0, 2 * std::numbers::pi));
}

double scale_of(const UserVariant& variant, int joint) {
  if (joint >= joints::LeftHipJoint && joint <= joints::RightToes) return variant.legs;
  if (joint >= joints::LeftHumerus && joint <= joints::LeftHand) return variant.arms;
  if (joint >= joints::RightHumerus) return variant.arms;
  return variant.trunk;
}

/// The same directions with other lengths. The root's path is scaled with the legs, its height too, so that a
/// foot that stood still stands still.
Pose rebuilt(const UserVariant& variant, const Pose& pose) {
  Pose other;
  other.row(joints::Root) = variant.legs * pose.row(joints::Root);
  for (int joint = 1; joint < joint_count; ++joint) {
    const int parent = joint_parents[static_cast<std::size_t>(joint)];
    other.row(joint) = other.row(parent) + scale_of(variant, joint) * (pose.row(joint) - pose.row(parent));
  }
  return other;
}

void add_noise(double sigma_m, RandomSource& random, std::vector<Pose>& poses) {
  for (Pose& pose : poses)
    for (Eigen::Index i = 0; i < pose.size(); ++i) pose.data()[i] += sigma_m * normal(random);
}

/// Gaps whose lengths are geometrically distributed about the mean burst; in a gap the last frame that came
/// stands in.
void lose(const UserVariant& variant, double fps, RandomSource& random, std::vector<Pose>& poses) {
  const double burst = std::max(1.0, variant.loss_burst_s * fps);
  const double begin = variant.lost_share / (burst * (1 - variant.lost_share)), end = 1 / burst;
  bool lost = false;
  for (std::size_t frame = 1; frame < poses.size(); ++frame) {
    lost = lost ? !random.chance(end) : random.chance(begin);
    if (lost) poses[frame] = poses[frame - 1];
  }
}

void delay(double delay_s, double fps, std::vector<Pose>& poses) {
  const auto frames = std::min(static_cast<std::size_t>(std::lround(delay_s * fps)), poses.size());
  const Pose first = poses.front();
  std::shift_right(poses.begin(), poses.end(), static_cast<std::ptrdiff_t>(frames));
  std::fill_n(poses.begin(), frames, first);
}

}  // namespace

Clip as_performed_by(const UserVariant& variant, const Clip& clip, unsigned seed) {
  Clip performed = clip;
  if (performed.poses.empty()) return performed;
  if (variant.legs != 1 || variant.trunk != 1 || variant.arms != 1)
    for (Pose& pose : performed.poses) pose = rebuilt(variant, pose);
  RandomSource random(seed);
  if (variant.noise_m > 0) add_noise(variant.noise_m, random, performed.poses);
  if (variant.lost_share > 0) lose(variant, clip.fps, random, performed.poses);
  if (variant.delay_s > 0) delay(variant.delay_s, clip.fps, performed.poses);
  return performed;
}

std::vector<UserVariant> other_builds() {
  return {{.name = "user at 85 %", .legs = 0.85, .trunk = 0.85, .arms = 0.85},
          {.name = "user at 115 %", .legs = 1.15, .trunk = 1.15, .arms = 1.15},
          {.name = "arms 20 % longer", .arms = 1.2},
          {.name = "legs 10 % longer, arms 10 % shorter", .legs = 1.1, .arms = 0.9}};
}

std::vector<UserVariant> disturbances() {
  return {{.name = "5 % of frames lost", .lost_share = 0.05},
          {.name = "20 % of frames lost", .lost_share = 0.20},
          {.name = "40 % of frames lost", .lost_share = 0.40},
          {.name = "noise 5 mm", .noise_m = 0.005},
          {.name = "noise 1 cm", .noise_m = 0.01},
          {.name = "noise 2 cm", .noise_m = 0.02},
          {.name = "delay 50 ms", .delay_s = 0.05},
          {.name = "delay 100 ms", .delay_s = 0.10},
          {.name = "delay 200 ms", .delay_s = 0.20}};
}

}  // namespace abrazo
