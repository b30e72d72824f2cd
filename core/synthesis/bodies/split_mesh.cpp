#include "core/synthesis/bodies/split_mesh.hpp"

#include <cmath>

#include "core/motion/body/joint_set.hpp"

namespace abrazo {

namespace {

double decayed(double distance_m, double width_m) {
  return std::exp(-(distance_m * distance_m) / (width_m * width_m));
}

bool is_of_arm(int vertex) {
  const int joint = vertex % joint_count;
  return (joint >= joints::left_elbow && joint <= joints::left_hand) ||
         (joint >= joints::right_elbow && joint <= joints::right_hand);
}

/// q_as. Arms reach; what they do not touch stays in proportion to its body above the floor.
Eigen::RowVector3d kept_vector(const RelationWeights& weights, int a, int s,
                               const Eigen::RowVector3d& recorded, const Eigen::RowVector3d& rebuilt) {
  Eigen::RowVector3d kept = recorded;
  if (!is_of_arm(a) && !is_of_arm(s))
    kept.y() = rebuilt.y() + weights.recorded_height * (recorded.y() - rebuilt.y());
  return kept;
}

}  // namespace

double relation_weight(const RelationWeights& weights, double distance_m) {
  if (distance_m >= weights.far_m) return 0;
  // Less its value at the limit, so that nothing jumps when a pair comes near.
  const auto reaching = [&](double width_m) {
    return decayed(distance_m, width_m) - decayed(weights.far_m, width_m);
  };
  return weights.contact * reaching(weights.contact_width_m) + weights.near * reaching(weights.near_width_m);
}

/// M^T delta with the weights of the Laplacian; those of a vertex add up to 1.
PairPose SplitMesh::transposed_times(const PairPose& delta) const {
  PairPose product = delta;
  for (int j = 0; j < pair_vertex_count; ++j)
    for (int l = 0; l < pair_vertex_count; ++l)
      if (const double weight = laplacian_.weight(j, l); weight != 0) product.row(l) -= weight * delta.row(j);
  return product;
}

void SplitMesh::build(std::span<const MeshEdge> edges, const PairPose& recorded, const PairPose& rebuilt,
                      const RelationWeights& weights) {
  laplacian_.build(edges, recorded, EdgeWeights::Inverse);
  PairPose delta = laplacian_.apply(rebuilt);
  energy_ = laplacian_.gram();
  start_ = transposed_times(delta);
  for (const auto& [a, s] : edges) {
    if (!is_inter_body({a, s})) continue;
    const Eigen::RowVector3d was = recorded.row(a) - recorded.row(s);
    const Eigen::RowVector3d changed = rebuilt.row(a) - rebuilt.row(s);
    const Eigen::RowVector3d difference =
        decayed(was.norm(), weights.mesh_width_m) * (kept_vector(weights, a, s, was, changed) - changed);
    delta.row(a) += laplacian_.weight(a, s) * difference;
    delta.row(s) -= laplacian_.weight(s, a) * difference;
  }
  goal_ = transposed_times(delta);
  for (int a = 0; a < joint_count; ++a)
    for (int s = joint_count; s < pair_vertex_count; ++s) {
      const Eigen::RowVector3d was = recorded.row(a) - recorded.row(s);
      const double k = relation_weight(weights, was.norm());
      if (k <= 0) continue;
      const Eigen::RowVector3d changed = rebuilt.row(a) - rebuilt.row(s);
      const Eigen::RowVector3d kept = kept_vector(weights, a, s, was, changed);
      energy_(a, a) += k;
      energy_(s, s) += k;
      energy_(a, s) -= k;
      energy_(s, a) -= k;
      start_.row(a) += k * changed;
      start_.row(s) -= k * changed;
      goal_.row(a) += k * kept;
      goal_.row(s) -= k * kept;
    }
}

}  // namespace abrazo
