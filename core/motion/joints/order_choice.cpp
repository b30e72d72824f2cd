#include "core/motion/joints/order_choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/motion/body/joint_set.hpp"
#include "core/motion/joints/map_choice.hpp"

namespace abrazo {

namespace {

constexpr double steady = 0.05;  ///< of a person's bones, mean relative deviation and difference of the sides
constexpr double clearly_less = 3;  ///< than that of the next order

/// Mean over the long bones of limbs of how their length varies and differs between the sides, relative to
/// it.
double unsteadiness(const JointOrder& order, const std::vector<Positions>& frames) {
  constexpr double none = std::numeric_limits<double>::infinity();
  NamedMotion motion;
  motion.points = order.points;
  motion.parents.assign(order.points.size(), -1);
  const ChosenMap chosen = choose_map(motion, {});
  if (!chosen.fits()) return none;
  constexpr std::array<std::pair<int, int>, 4> bones = {{{joints::left_hip, joints::left_knee},
                                                         {joints::left_knee, joints::left_ankle},
                                                         {joints::left_shoulder, joints::left_elbow},
                                                         {joints::left_elbow, joints::left_wrist}}};
  constexpr std::size_t most_frames = 50;
  const std::size_t step = std::max<std::size_t>(1, frames.size() / most_frames);
  double sum = 0;
  for (const auto& [from, to] : bones) {
    std::array<double, 2> means{};
    double deviation = 0;
    for (const bool left : {true, false}) {
      const int start = left ? from : mirrored_joint(from), end = left ? to : mirrored_joint(to);
      double total = 0, squares = 0, count = 0;
      for (std::size_t f = 0; f < frames.size(); f += step) {
        const Pose pose = chosen.binding.joints_of(frames[f]);
        const double length = (pose.row(start) - pose.row(end)).norm();
        if (!std::isfinite(length)) continue;
        total += length, squares += length * length, ++count;
      }
      if (count == 0 || total == 0) return none;
      const double mean = total / count;
      means[left ? 0 : 1] = mean;
      deviation += std::sqrt(std::max(0.0, squares / count - mean * mean)) / mean / 2;
    }
    sum += deviation + std::abs(means[0] - means[1]) / (means[0] + means[1]);
  }
  return sum / bones.size();
}

}  // namespace

const JointOrder* order_of_steady_bones(const std::vector<const JointOrder*>& orders,
                                        const std::vector<Positions>& frames) {
  const JointOrder* best = nullptr;
  double least = steady, next = std::numeric_limits<double>::infinity();
  for (const JointOrder* order : orders) {
    const double here = unsteadiness(*order, frames);
    if (here < least) {
      if (best) next = least;
      best = order, least = here;
    } else {
      next = std::min(next, here);
    }
  }
  return best && next > clearly_less * least ? best : nullptr;
}

}  // namespace abrazo
