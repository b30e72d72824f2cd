#pragma once

#include <vector>

#include "core/choreography/dancer_body.hpp"
#include "core/choreography/posture.hpp"

namespace abrazo {

/// A dancer's feet over the frames of a dance.
struct FeetTrack {
  std::vector<FootPosture> left, right;
};

/// Path of the weight on the floor: on the standing foot while the other moves, and from one foot to the
/// other while both stand. One point per frame, y = 0.
std::vector<Vec3> weight_path(const FeetTrack& feet, double fps);

/// Path of a centre of mass at `height_m` whose zero moment point is `zero_moment_point`: the bounded
/// solution of c - (h / g) c'' = p, x and z each (linear inverted pendulum, Kajita et al. 2001). It leads the
/// weight and sways less than the distance of the feet. y = 0.
std::vector<Vec3> pendulum_path(const std::vector<Vec3>& zero_moment_point, double height_m, double fps);

/// Moves the trunks horizontally so that the feet can support the centre of mass: the zero moment point stays
/// within the support. Turns, lean and height of the trunks are kept; arms are assumed to hang.
/// @param share of the correction; 1 = perfectly balanced
void balance_trunks(const DancerBody& body, const FeetTrack& feet, double fps, double share,
                    std::vector<TrunkPosture>& trunks);

}  // namespace abrazo
