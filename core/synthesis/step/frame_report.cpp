#include <cmath>

#include "core/mesh/other_body.hpp"
#include "core/synthesis/step/frame_pipeline.hpp"

namespace abrazo {

void FramePipeline::report(const PairEditor::Outcome& outcome) {
  using Relaxation = PairEditor::Relaxation;
  out_.result = editor_.result();
  out_.morph_steps.assign(editor_.steps().begin(), editor_.steps().end());
  out_.status = outcome.relaxation == Relaxation::None ? StepStatus::Ok : StepStatus::Relaxed;
  switch (outcome.relaxation) {
    case Relaxation::None:
      out_.message.clear();
      break;
    case Relaxation::PassiveFeet:
      out_.message = "the partner's foot locks were let go";
      break;
    case Relaxation::Feet:
      out_.message = "all foot locks were let go";
      break;
    case Relaxation::Capsules:
      out_.message = "foot locks and collisions were let go";
      break;
    case Relaxation::Everything:
      out_.message = "only bone lengths were kept";
      break;
  }
  const EditTask& task = editor_.task();
  const Laplacian& laplacian = editor_.laplacian();
  out_.energy.deformation = laplacian.deformation_energy(out_.result, out_.selected_pair);
  out_.energy.velocity = task.has_previous ? 0.5 * (out_.result - task.velocity_target).squaredNorm() : 0.0;
  const double morph_sq = (out_.result.topRows<joint_count>() - out_.query_world).squaredNorm();
  out_.energy.constraint = 0.5 * settings_.morph_weight * morph_sq;
  out_.residual.morph_rms_m = std::sqrt(morph_sq / joint_count);
  out_.residual.bone_length_max = bone_length_error(out_.result, task.wanted);
  const int locked_bodies = !settings_.foot_locks || outcome.relaxation >= Relaxation::Feet ? 0
                            : outcome.relaxation == Relaxation::PassiveFeet                 ? 1
                                                                                            : 2;
  report_feet(locked_bodies);
  editor_.contacts().measure(out_.result, out_.collisions, out_.residual.penetration_max_m,
                             out_.residual.excess_penetration_max_m);

  const PairPose residuals = laplacian.apply(out_.result - out_.selected_pair);
  out_.edge_weights.clear();
  out_.edge_residuals_m.clear();
  for (const MeshEdge& edge : out_.edges) {
    out_.edge_weights.push_back(0.5 *
                                (laplacian.weight(edge[0], edge[1]) + laplacian.weight(edge[1], edge[0])));
    out_.edge_residuals_m.push_back(0.5 * (residuals.row(edge[0]).norm() + residuals.row(edge[1]).norm()));
  }
}

/// Feet that could not be held are not planted any more.
void FramePipeline::report_feet(int locked_bodies) {
  next_.locks.list(locked_bodies, out_.foot_locks);
  out_.residual.foot_lock_max_m = editor_.drift(next_.locks, locked_bodies);
  if (!plays()) return;
  FootPlants& plants = next_.motion.plants;
  for (const int f : {0, 1}) {
    if (!editor_.task().planted[static_cast<std::size_t>(f)]) continue;
    if (locked_bodies == 2)
      out_.foot_locks.push_back({false, f == 0});
    else
      plants.let_go(f, out_.result.row(FootLocks::ankles[static_cast<std::size_t>(2 + f)] + 1));
  }
}

void exchange_roles(const FrameResult& solved, FrameResult& exchanged) {
  exchanged = solved;
  const auto exchange_bodies = [](PairPose& pair) {
    const Pose first = pair.topRows<joint_count>();
    pair.topRows<joint_count>() = pair.bottomRows<joint_count>().eval();
    pair.bottomRows<joint_count>() = first;
  };
  exchange_bodies(exchanged.selected_pair);
  exchange_bodies(exchanged.result);
  for (PairPose& step : exchanged.morph_steps) exchange_bodies(step);
  for (MeshEdge& edge : exchanged.edges) edge = edge_of_other_body(edge);
  for (MeshTetrahedron& tetrahedron : exchanged.tetrahedra)
    tetrahedron = tetrahedron_of_other_body(tetrahedron);
  for (FootLock& lock : exchanged.foot_locks) lock.active_body = !lock.active_body;
  for (HandHold& hold : exchanged.holds) {
    std::swap(hold.active_left, hold.passive_left);
    hold.offset = -hold.offset;
  }
  for (CapsuleContact& contact : exchanged.collisions) {
    std::swap(contact.a, contact.b);
    for (int* vertex : {&contact.a[0], &contact.a[1], &contact.b[0], &contact.b[1]})
      *vertex = vertex_of_other_body(*vertex);
  }
  for (Candidate& candidate : exchanged.candidates)
    std::swap(candidate.cost.temporal_active, candidate.cost.temporal_passive);
}

}  // namespace abrazo
