#pragma once

#include <optional>

#include "core/motion/body.hpp"
#include "core/selection/motion_history.hpp"
#include "core/synthesis/foot_locks.hpp"
#include "core/synthesis/transition.hpp"

namespace abrazo {

/// What a frame needs of those before it, as one value; some 24 kB without a pointer. World space, metres.
struct FrameMemory {
  int frames_since_reset = 0;
  PairPose previous = PairPose::Zero();         ///< V'_{i-1}
  PairPose before_previous = PairPose::Zero();  ///< V'_{i-2}
  double previous_dt_s = 0;
  Pose previous_query = Pose::Zero();  ///< q'_in of the previous frame
  std::optional<double> previous_heading;
  int current_pair = -1;         ///< the source of the previous frame
  bool has_good_result = false;  ///< `previous` is what is held after a failure
  FootLocks locks;
  Transition transition;
  MotionHistory history;          ///< q'_in of the last two seconds
  std::optional<Body> user_body;  ///< given, or measured on the first pose that can be a person's
};

}  // namespace abrazo
