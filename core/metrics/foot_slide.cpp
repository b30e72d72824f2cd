#include "core/metrics/foot_slide.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "core/motion/body.hpp"
#include "core/motion/joint_set.hpp"

namespace abrazo {

namespace {

constexpr double weight_height_m = 0.025;
constexpr double sliding_m_s = 0.025 * 30;

double horizontal_distance(const Pose& a, const Pose& b, int joint) {
  return std::hypot(a(joint, 0) - b(joint, 0), a(joint, 2) - b(joint, 2));
}

/// Weight of a speed at a height above the rest: 1 on the floor, 0 from 2.5 cm on.
double closeness(double height_m) {
  return 2 - std::exp2(std::clamp(height_m / weight_height_m, 0.0, 1.0));
}

struct Sums {
  double toe_m = 0, ankle_m = 0, weighted_m = 0;
  int landed = 0, sliding = 0, standing_steps = 0;
};

/// Adds what the two feet do from one frame to the next.
void add_step(const Pose& before, const Pose& after, double fps, double floor_m, double landing_height_m,
              Sums& sums) {
  using namespace joints;
  bool stands = false;
  for (const auto& [ankle, toe_base] :
       {std::array{left_ankle, left_toe_base}, std::array{right_ankle, right_toe_base}}) {
    const double toe_m = horizontal_distance(before, after, toe_base);
    const double higher = std::max(before(toe_base, 1), after(toe_base, 1)) - floor_m;
    sums.weighted_m += toe_m * closeness(0.5 * (before(toe_base, 1) + after(toe_base, 1)) - floor_m);
    if (higher >= landing_height_m) continue;
    stands = true;
    ++sums.landed;
    sums.toe_m += toe_m;
    sums.ankle_m += horizontal_distance(before, after, ankle);
    sums.sliding += toe_m * fps > sliding_m_s;
  }
  sums.standing_steps += stands;
}

}  // namespace

FootSlide measure_foot_slide(std::span<const Pose> poses, double fps, double floor_m,
                             double landing_height_m) {
  if (!(fps > 0)) throw std::invalid_argument("measure_foot_slide: the frame rate must be positive");
  FootSlide slide;
  Sums sums;
  for (std::size_t frame = 1; frame < poses.size(); ++frame)
    add_step(poses[frame - 1], poses[frame], fps, floor_m, landing_height_m, sums);
  slide.foot_frames = poses.empty() ? 0 : 2 * static_cast<int>(poses.size() - 1);
  slide.landed_frames = sums.landed;
  if (slide.foot_frames > 0) slide.weighted_m_s = sums.weighted_m * fps / slide.foot_frames;
  if (sums.landed == 0) return slide;
  slide.speed_m_s = sums.toe_m * fps / sums.landed;
  slide.ankle_speed_m_s = sums.ankle_m * fps / sums.landed;
  slide.distance_m_per_s = sums.toe_m * fps / sums.standing_steps;
  slide.sliding_share = static_cast<double>(sums.sliding) / sums.landed;
  return slide;
}

double toe_rest_height(std::span<const Pose> poses) {
  return poses.empty() ? 0 : body_of(poses).toe_rest_height;
}

}  // namespace abrazo
