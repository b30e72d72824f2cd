#pragma once

#include <vector>

#include "core/choreography/dancer_body.hpp"
#include "core/choreography/posture.hpp"

namespace abrazo {

/// Takes the jerks out of one arm's motion: where the hand passes a direction in which the elbow could go
/// either way, the elbow comes about over several frames instead of one, and so does the wrist. Lengths stay
/// exact and hands stay where they are (but for what the reach of a turned wrist demands).
/// @param chests      orientation of the chest in every frame; as many as poses
/// @param half_width  frames over which is averaged, to either side
void smooth_arm(const DancerBody& body, Side side, const std::vector<Turn>& chests, int half_width,
                std::vector<Pose>& poses);

}  // namespace abrazo
