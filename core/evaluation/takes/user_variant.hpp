#pragma once

#include <string>
#include <vector>

#include "core/motion/body/clip.hpp"

namespace abrazo {

/// A user of another build than the captured one, or with a disturbed capture.
struct UserVariant {
  std::string name = "as captured";
  double legs = 1, trunk = 1, arms = 1;  ///< bone lengths relative to the captured ones
  double noise_m = 0;                    ///< normal error of each coordinate, standard deviation
  double lost_share = 0;                 ///< lost frames; each is replaced by the previous one
  double loss_burst_s = 0.05;            ///< mean length of a gap
  double delay_s = 0;                    ///< delay of all frames
};

/// The motion of such a user. Directions of bones are kept; the path is scaled with the legs, so that
/// standing feet stay still. Same seed, same motion.
Clip as_performed_by(const UserVariant& variant, const Clip& clip, unsigned seed);

/// Users of other builds, and disturbed input, as the report shows them.
std::vector<UserVariant> other_builds();
std::vector<UserVariant> disturbances();

}  // namespace abrazo
