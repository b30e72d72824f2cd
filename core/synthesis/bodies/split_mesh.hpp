#pragma once

#include <span>

#include "core/base/positions.hpp"
#include "core/mesh/interaction_mesh.hpp"
#include "core/mesh/laplacian.hpp"

namespace abrazo {

/// Weights of the edges between and within two bodies. Distances are those of the recording.
struct RelationWeights {
  double contact = 30;  ///< of a pair of joints that touch
  double contact_width_m = 0.10;
  double near = 8;  ///< of one that is near
  double near_width_m = 0.30;
  double far_m = 0.5;          ///< pairs farther apart have only the mesh
  double mesh_width_m = 0.35;  ///< a mesh edge between the bodies keeps its vector by exp(-(d/width)^2)
  /// Share of the recorded height of one joint above the other, if neither is an elbow, wrist or hand; the
  /// rest is that of the rebuilt bodies, which stand on one floor.
  double recorded_height = 0.5;
};

/// An interaction mesh whose edges have targets for changed bodies: edges within a body have the shape of
/// the rebuilt body, and so scale with it; edges between the bodies have the kept vector where the bodies are
/// near, and that of the rebuilt pair where they are far. The kept vector q is the recorded one if an elbow,
/// wrist or hand is at one of its ends; otherwise its height is between the recorded and the rebuilt one. In
/// addition a spring for every near pair of joints,
///   k(d) = contact exp(-(d/contact_width)^2) + near exp(-(d/near_width)^2),
/// whether or not the mesh has an edge there, so that it does not change with the mesh. Energy:
///   1/2 sum_j |L(v_j) - delta_j|^2 + 1/2 sum k |(v_a - v_s) - q_as|^2,
/// delta_j = sum_l w_jl g_jl with these edges g.
class SplitMesh {
 public:
  /// @param rebuilt  both new bodies in the recorded shape; @see rebuilt()
  void build(std::span<const MeshEdge> edges, const PairPose& recorded, const PairPose& rebuilt,
             const RelationWeights& weights);

  const VertexMatrix& energy() const { return energy_; }  ///< K: its gradient is K V - linear
  /// The linear part with edges interpolated from the rebuilt pair's (0) to their targets (1).
  PairPose linear(double fraction) const { return start_ + fraction * (goal_ - start_); }
  const Laplacian& laplacian() const { return laplacian_; }

 private:
  PairPose transposed_times(const PairPose& delta) const;

  Laplacian laplacian_;
  VertexMatrix energy_;
  PairPose start_, goal_;
};

/// k(d) of RelationWeights.
double relation_weight(const RelationWeights& weights, double distance_m);

}  // namespace abrazo
