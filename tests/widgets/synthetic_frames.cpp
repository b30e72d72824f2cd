#include "tests/widgets/synthetic_frames.hpp"

#include <cmath>

#include "core/mesh/capsules.hpp"
#include "core/mesh/interaction_mesh.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::test {

FrameSnapshotPtr synthetic_frame(std::uint64_t index, double time_s) {
  auto frame = std::make_shared<FrameSnapshot>();
  frame->index = index;
  frame->time_s = time_s;
  frame->settings.alpha = 0.5;
  FrameResult& result = frame->result;
  const double sway = 0.1 * std::sin(static_cast<double>(index) / 10);
  result.selected_pair = facing_pair(0.65);
  result.result = result.selected_pair;
  result.result.bottomRows<joint_count>() = moved(result.passive(), 0, Vec3(sway, 0, 0.05));
  result.morph_steps = {result.selected_pair, result.result};
  frame->user = moved(result.active(), 0, Vec3(-0.25, 0, 0));
  result.query_world = frame->user;
  result.query_root = root_frame(frame->user);
  for (int c = 0; c < 5; ++c) {
    Candidate candidate;
    candidate.pair = c;
    candidate.feature_distance = 0.1 * (c + 1);
    candidate.cost = {0.1 + 0.02 * c, 0.02, 0.04 + 0.05 * c, 0};
    candidate.cost.total =
        candidate.cost.pose + 0.5 * (candidate.cost.temporal_active + candidate.cost.temporal_passive);
    result.candidates.push_back(candidate);
  }
  result.selected = 0;
  const InteractionMesh mesh = tetrahedralize(result.selected_pair);
  result.edges = mesh.edges;
  result.tetrahedra = mesh.tetrahedra;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    result.edge_weights.push_back(0.1);
    result.edge_residuals_m.push_back(0.001 * static_cast<double>(e % 20));
  }
  result.energy = {0.01, 0.004, 0.002};
  result.residual = {0.0004, 0.0002, 0.01, 0.003, 0.02};
  result.foot_locks = {{true, true}, {false, false}};
  result.collisions = {{{19, 20}, {44, 45}, 0.004, 0.01}};
  result.status = StepStatus::Ok;
  result.message.clear();
  result.timing.total_us = 400;
  return frame;
}

FrameSnapshotPtr frame_by_intent(std::uint64_t index, double time_s) {
  auto frame = std::make_shared<FrameSnapshot>(*synthetic_frame(index, time_s));
  frame->settings.selection = SelectionMethod::Intent;
  constexpr std::array<IntentCost, 5> costs = {{{0.10, 0.06, 0.03, 0, 0, 0.19},
                                                {0.09, 0.05, 0.03, 0, 0.03, 0.20},
                                                {0.12, 0.08, 0.03, 0, 0.03, 0.26},
                                                {0.16, 0.10, 0.03, 0, 0.03, 0.32},
                                                {0.20, 0.14, 0.09, 0, 0.03, 0.46}}};
  for (std::size_t c = 0; c < costs.size(); ++c) frame->result.candidates[c].intent = costs[c];
  frame->result.candidates[0].continuation = true;
  frame->result.intent.continued = 0;
  frame->result.intent.moves = {0.1F, 0.9F};
  return frame;
}

}  // namespace abrazo::test
