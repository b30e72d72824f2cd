#pragma once

#include "core/base/positions.hpp"
#include "core/synthesis/edit/constraints.hpp"

namespace abrazo {

/// Makes the lengths of pelvis and shoulder girdle consistent. Lengths taken from two bodies may be
/// impossible: no four points may have all the wanted distances between thorax, lower neck and shoulders.
/// This changes the lengths of pseudo-bones as little as possible, towards the angles of `shape`, so that
/// such points exist and are not much closer to coplanar than those of `shape`. Bones keep their lengths;
/// consistent lengths stay unchanged.
/// @param shape pose [m] with possible angles
/// @param[in,out] lengths  in the order of rigid_distances()
void make_lengths_fit(const PairPose& shape, RigidDistances& lengths);

}  // namespace abrazo
