#include "core/selection/motion_history.hpp"

#include <algorithm>
#include <cmath>

namespace abrazo {

namespace {

/// Poses come a little early or late; one that is this near to its turn is taken.
constexpr double early_s = 0.002;

MotionHistory::Sample relative_to(const Pose& world, const Vec3& origin) {
  MotionHistory::Sample sample;
  for (int joint = 0; joint < joint_count; ++joint)
    for (int axis = 0; axis < 3; ++axis)
      sample[static_cast<std::size_t>(3 * joint + axis)] =
          static_cast<float>(world(joint, axis) - origin[axis]);
  return sample;
}

bool is_usable(const MotionHistory::Kept& kept) {
  return std::isfinite(kept.since_s) && kept.since_s >= 0 &&
         std::all_of(kept.positions.begin(), kept.positions.end(), [](float x) { return std::isfinite(x); });
}

}  // namespace

void MotionHistory::clear() {
  first_ = count_ = 0;
}

void MotionHistory::add(const Pose& world, const RootFrame& root, double elapsed_s) {
  root_ = root;
  if (count_ == 0) {
    origin_ = Vec3(root.position.x(), 0, root.position.z());
    newest_ = {0, relative_to(world, origin_)};
    ring_[first_] = newest_;
    count_ = 1;
    return;
  }
  newest_.since_s += static_cast<float>(elapsed_s);
  newest_.positions = relative_to(world, origin_);
  if (static_cast<double>(newest_.since_s) < between_s - early_s) return;
  if (count_ == most_samples)
    first_ = (first_ + 1) % most_samples;
  else
    ++count_;
  ring_[(first_ + count_ - 1) % most_samples] = newest_;
  newest_.since_s = 0;
}

void MotionHistory::sample(double lag_s, std::span<float, coordinates> xyz) const {
  const Kept* later = &newest_;
  const Kept* earlier = &newest_;
  auto left_s = static_cast<float>(std::max(0.0, lag_s));
  float share = 0;  // of the earlier
  float gap_s = newest_.since_s;
  for (std::size_t i = count_; i-- > 0;) {
    later = earlier;
    earlier = &kept(i);
    if (gap_s > 0 && left_s <= gap_s) {
      share = left_s / gap_s;
      break;
    }
    left_s -= gap_s;
    gap_s = earlier->since_s;
    share = 1;
  }
  const Vec3 at = root_.position - origin_;
  const auto sine = static_cast<float>(std::sin(root_.heading_rad));
  const auto cosine = static_cast<float>(std::cos(root_.heading_rad));
  const std::array<float, 3> root = {static_cast<float>(at.x()), static_cast<float>(at.y()),
                                     static_cast<float>(at.z())};
  for (std::size_t c = 0; c < coordinates; c += 3) {
    std::array<float, 3> p{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float new_one = later->positions[c + axis];
      p[axis] = new_one + share * (earlier->positions[c + axis] - new_one) - root[axis];
    }
    xyz[c] = cosine * p[0] - sine * p[2];
    xyz[c + 1] = p[1];
    xyz[c + 2] = sine * p[0] + cosine * p[2];
  }
}

bool MotionHistory::restore(const Vec3& origin, const RootFrame& root, std::span<const Kept> kept,
                            const Kept& newest) {
  clear();
  const bool usable = origin.allFinite() && root.position.allFinite() && std::isfinite(root.heading_rad) &&
                      kept.size() <= most_samples && is_usable(newest) &&
                      std::all_of(kept.begin(), kept.end(), is_usable);
  if (!usable) return false;
  origin_ = origin;
  root_ = root;
  std::copy(kept.begin(), kept.end(), ring_.begin());
  first_ = 0;
  count_ = kept.size();
  newest_ = newest;
  return true;
}

}  // namespace abrazo
