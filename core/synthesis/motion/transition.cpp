#include "core/synthesis/motion/transition.hpp"

#include <algorithm>
#include <cmath>

namespace abrazo {

namespace {
constexpr double longest_share = 5.0 / 3;  ///< of the shortest fade: of a change by `large_turn`
constexpr double large_turn = 1.0;         ///< mean over the bones [rad]
constexpr double fastest_turn = 25;        ///< [rad/s]; a bone that is faster flipped over, and did not move
}  // namespace

double quintic_fade(double s) {
  return 1 - s * s * s * (10 + s * (-15 + 6 * s));
}

double quintic_slope(double s) {
  return s * (1 - s * s * (6 + s * (-8 + 3 * s)));
}

BodyShape Transition::shown(const BodyShape& source) const {
  if (is_over()) return source;
  BodyShape shape = source;
  const double share = elapsed_s_ / duration_s_;
  const double fade = quintic_fade(share), slope = duration_s_ * quintic_slope(share);
  for (std::size_t b = 0; b < turns_.size(); ++b)
    shape.directions[b] = turned(source.directions[b], fade * turns_[b] + slope * rates_[b]);
  shape.root_height += fade * height_ + slope * climb_;
  return shape;
}

void Transition::begin(const BodyShape& seen, const BodyShape& source, const BodyShape& seen_before,
                       const BodyShape& source_before, double before_s, double least_s) {
  double angle_sum = 0;
  for (std::size_t b = 0; b < turns_.size(); ++b) {
    turns_[b] = turn_between(source.directions[b], seen.directions[b]);
    angle_sum += turns_[b].norm();
    rates_[b].setZero();
    if (before_s <= 0) continue;
    const Vec3 before = turn_between(source_before.directions[b], seen_before.directions[b]);
    const Vec3 rate = (turns_[b] - before) / before_s;
    if (rate.norm() <= fastest_turn) rates_[b] = rate;
  }
  height_ = seen.root_height - source.root_height;
  climb_ = before_s > 0 ? (height_ - (seen_before.root_height - source_before.root_height)) / before_s : 0;
  const double large = std::min(1.0, angle_sum / bone_count / large_turn);
  duration_s_ = least_s * (1 + large * (longest_share - 1));
  elapsed_s_ = 0;
}

}  // namespace abrazo
