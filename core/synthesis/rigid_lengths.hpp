#pragma once

#include "core/base/positions.hpp"
#include "core/synthesis/constraints.hpp"

namespace abrazo {

/// Lengths of pelvis and shoulder girdle that were put together from two bodies need not fit: no four points
/// have all the distances between thorax, lower neck and shoulders that were asked for. This moves the
/// pseudo-bones' lengths, by as little as it takes, towards the angles of `shape`, so that points with all of
/// them exist and are not much nearer to lying in a plane than those of `shape`. Bones keep their lengths,
/// and lengths that fit stay as they are.
/// @param shape            pose [m] with the angles that are possible
/// @param[in,out] lengths  in the order of rigid_distances()
void make_lengths_fit(const PairPose& shape, RigidDistances& lengths);

}  // namespace abrazo
