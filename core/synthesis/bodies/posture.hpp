#pragma once

#include "core/mesh/laplacian.hpp"

namespace abrazo {

/// Weights of the posture of a body, against the unit weight of the mesh's shape.
struct PostureWeights {
  double legs = 250;  ///< of hip to ankle, ankle to toe base, and root to hip
  double trunk = 50;  ///< of root to neck and shoulders: it gives way before the legs do
};

/// Adds k/2 |(v_j - v_i) - (b_j - b_i)|^2 for legs and trunk of both bodies, b the rebuilt pair, to an energy
/// whose gradient is K V - R. Hip to ankle is the angle of the knee; with feet and pelvis it is the height of
/// the pelvis.
/// @param[in,out] energy  K
/// @param[in,out] linear  R
void add_posture(const PairPose& rebuilt, const PostureWeights& weights, VertexMatrix& energy,
                 PairPose& linear);

}  // namespace abrazo
