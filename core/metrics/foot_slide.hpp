#pragma once

#include <span>

#include "core/base/positions.hpp"

namespace abrazo {

/// How far feet slide while they are on the floor. Speeds are horizontal, from one frame to the next; a foot
/// counts as landed in a frame when it is so at both ends of that step.
struct FootSlide {
  double speed_m_s = 0;         ///< mean speed of landed toe-bases
  double ankle_speed_m_s = 0;   ///< of the ankles of those feet
  double distance_m_per_s = 0;  ///< travelled by landed toe-bases, the two feet together, per second in which
                                ///< at least one foot is landed
  double weighted_m_s = 0;   ///< mean over all foot frames of v (2 - 2^(h / 2.5 cm)), h the height above the
                             ///< rest, 0 from 2.5 cm on (Zhang et al. 2018, MANN)
  double sliding_share = 0;  ///< of the landed foot frames: toe-base moves more than 2.5 cm in 1/30 s
  int landed_frames = 0;     ///< foot frames
  int foot_frames = 0;       ///< looked at: two for each step from frame to frame
};

/// @param floor_m         height at which a standing foot's toe-base rests (`toe_rest_height`)
/// @param landing_height_m  a foot is landed while its toe-base is less than this above `floor_m`
/// @throws std::invalid_argument when the rate is not positive
FootSlide measure_foot_slide(std::span<const Pose> poses, double fps, double floor_m,
                             double landing_height_m = 0.03);

/// 5th percentile of the toe-base heights: where a standing foot's toe-base rests (Body::toe_rest_height); 0
/// for no poses.
double toe_rest_height(std::span<const Pose> poses);

}  // namespace abrazo
