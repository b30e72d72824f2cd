#include "core/bodies/retargeted_frame.hpp"

#include "core/mesh/interaction_mesh.hpp"
#include "core/mesh/laplacian.hpp"

namespace abrazo {

FrameResult frame_result_of(const RetargetedPair& pair, std::size_t frame) {
  const RetargetedFrame& made = pair.frames.at(frame);
  FrameResult result;
  result.query_world = pair.recorded.active.poses.at(frame);
  result.selected_pair << pair.recorded.active.poses.at(frame), pair.recorded.passive.poses.at(frame);
  InteractionMesh mesh = tetrahedralize(result.selected_pair);
  result.result = made.pose;
  result.morph_steps = {made.pose};
  Laplacian laplacian;
  laplacian.build(mesh.edges, result.selected_pair, EdgeWeights::Inverse);
  const PairPose residuals = laplacian.apply(made.pose - result.selected_pair);
  for (const auto& [a, b] : mesh.edges) {
    result.edge_weights.push_back(0.5 * (laplacian.weight(a, b) + laplacian.weight(b, a)));
    result.edge_residuals_m.push_back(0.5 * (residuals.row(a).norm() + residuals.row(b).norm()));
  }
  result.energy.deformation = laplacian.deformation_energy(made.pose, result.selected_pair);
  result.edges = std::move(mesh.edges);
  result.tetrahedra = std::move(mesh.tetrahedra);

  CapsuleContacts contacts;
  contacts.prepare(result.selected_pair, pair.capsules.recorded_active, pair.capsules.recorded_passive);
  contacts.wear(pair.capsules.active, pair.capsules.passive);
  contacts.measure(made.pose, result.collisions, result.residual.penetration_max_m,
                   result.residual.excess_penetration_max_m);
  result.residual.bone_length_max = made.bone_error;
  result.residual.foot_lock_max_m = made.foot_drift_m;
  for (std::size_t foot = 0; foot < made.stands.size(); ++foot)
    if (made.stands[foot]) result.foot_locks.push_back({foot < 2, foot % 2 == 0});
  for (const HandEnds& hands : all_hand_ends)
    if (hands_hold(result.selected_pair, hands))
      result.holds.push_back({hands.active == joints::left_hand, hands.passive == joints::left_hand, 1,
                              Vec3(result.selected_pair.row(hands.passive + joint_count) -
                                   result.selected_pair.row(hands.active))});
  result.status = made.is_nearest_only() ? StepStatus::Relaxed : StepStatus::Ok;
  result.message = made.is_nearest_only() ? made.shortfall() : "";
  return result;
}

}  // namespace abrazo
