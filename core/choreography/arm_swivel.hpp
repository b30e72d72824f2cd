#pragma once

#include <vector>

#include "core/choreography/dancer_body.hpp"
#include "core/choreography/posture.hpp"

namespace abrazo {

/// Smooths one arm's motion: where the hand passes a direction in which the elbow is ambiguous, elbow and
/// wrist turn over several frames instead of one. Lengths stay exact and hands stay in place (except as the
/// reach of a turned wrist requires).
/// @param chests      orientation of the chest in every frame; as many as poses
/// @param half_width half width of the average [frames]
void smooth_arm(const DancerBody& body, Side side, const std::vector<Turn>& chests, int half_width,
                std::vector<Pose>& poses);

}  // namespace abrazo
