#pragma once

#include <optional>

#include "core/motion/body/body.hpp"
#include "core/selection/motion_history.hpp"
#include "core/synthesis/bodies/shown_bodies.hpp"
#include "core/synthesis/edit/foot_locks.hpp"
#include "core/synthesis/motion/partner_motion.hpp"
#include "core/synthesis/step/user_measure.hpp"

namespace abrazo {

/// Everything a frame needs of previous frames, as one value of about 33 kB without pointers. World space,
/// metres.
struct FrameMemory {
  int frames_since_reset = 0;
  PairPose previous = PairPose::Zero();         ///< V'_{i-1}
  PairPose before_previous = PairPose::Zero();  ///< V'_{i-2}
  double previous_dt_s = 0;
  Pose previous_query = Pose::Zero();  ///< q'_in of the previous frame
  std::optional<double> previous_heading;
  int current_pair = -1;         ///< the source of the previous frame
  bool has_good_result = false;  ///< `previous` is the pose to hold after a failure
  FootLocks locks;
  PartnerMotion motion;           ///< used by the playback `continuous`
  bool partner_is_shown = false;  ///< `previous` has a partner to continue from, even after a loss of
                                  ///< tracking
  MotionHistory history;          ///< q'_in of the last two seconds
  UserMeasure user;               ///< body of the user: given, or measured over the first seconds
  ShownMemory shown;              ///< the characters on other bodies than the library's
};

}  // namespace abrazo
