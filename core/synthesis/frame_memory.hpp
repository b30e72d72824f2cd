#pragma once

#include <optional>

#include "core/motion/body/body.hpp"
#include "core/selection/motion_history.hpp"
#include "core/synthesis/foot_locks.hpp"
#include "core/synthesis/partner_motion.hpp"
#include "core/synthesis/user_measure.hpp"

namespace abrazo {

/// What a frame needs of those before it, as one value; some 27 kB without a pointer. World space, metres.
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
  PartnerMotion motion;           ///< with the playback `continuous`
  bool partner_is_shown = false;  ///< `previous` is a partner to go on from, also where tracking was lost
  MotionHistory history;          ///< q'_in of the last two seconds
  UserMeasure user;               ///< given, or measured over the first seconds
};

}  // namespace abrazo
