#pragma once

#include <optional>
#include <vector>

#include "core/motion/body/clip.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

struct UpAxisChoice {
  UpAxis axis = UpAxis::Y;
  bool guessed = false;                  ///< not stated, or against what is stated
  std::optional<ImportWarning> warning;  ///< of the kind "up-axis"
};

/// The axis that points up, by what the file states and how the person stands.
///
/// A person is upright along an axis in a frame if the head is above the hips and the hips above the feet,
/// within 45 degrees of it. The stated axis holds if that is so in a tenth of the frames: the others may
/// show a handstand or somebody on the floor. Otherwise another axis is taken if the person is upright
/// along it in most frames, with a question. The floor is expected at 0: hands that rest on it below the head
/// are a handstand, and a body that stays close to it lies there.
/// Without a statement it is Y or Z, as the head is above the feet; Y pointing down, as in the space of a
/// camera, -Z or X only where nobody stands along these.
/// @param stated  by the file; none if its format has no axes
/// @param poses   at least one, in the file's unit and axes
UpAxisChoice choose_up_axis(std::optional<UpAxis> stated, const std::vector<Pose>& poses);

}  // namespace abrazo
