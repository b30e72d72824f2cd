#pragma once

#include <algorithm>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/selection/history_kernel.hpp"

namespace abrazo::test {

inline std::vector<int> all_pairs(const MotionLibrary& library) {
  std::vector<int> pairs(static_cast<std::size_t>(library.pair_count()));
  std::iota(pairs.begin(), pairs.end(), 0);
  return pairs;
}

inline std::vector<int> pairs_of_take(const MotionLibrary& library, const std::string& name) {
  std::vector<int> pairs = all_pairs(library);
  std::erase_if(pairs, [&](int pair) { return library.take_of(pair).name != name; });
  return pairs;
}

/// Of somebody who did this.
inline MotionHistory history_of(std::span<const Pose> poses, double fps = 60) {
  MotionHistory history;
  for (const Pose& pose : poses) history.add(pose, root_frame(pose), 1 / fps);
  return history;
}

/// Up to this frame of it.
inline MotionHistory history_at(const std::vector<Pose>& poses, int frame) {
  return history_of(std::span(poses).first(static_cast<std::size_t>(frame) + 1));
}

}  // namespace abrazo::test
