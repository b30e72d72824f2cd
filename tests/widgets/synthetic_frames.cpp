#include "tests/widgets/synthetic_frames.hpp"

#include <cmath>

#include "core/mesh/capsules.hpp"
#include "core/mesh/interaction_mesh.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::test {
namespace {

constexpr int pairs_per_take = 4;

void add_take(LibraryColumns& columns, const std::string& name, const std::string& label) {
  const auto take = static_cast<std::uint32_t>(columns.takes.size());
  LibraryTake about;
  about.name = name;
  about.frames = pairs_per_take;
  about.labels = {{0, pairs_per_take, label, "", ""}};
  columns.takes.push_back(about);
  for (std::uint32_t frame = 0; frame < pairs_per_take; ++frame) {
    const PairPose world = facing_pair(0.6 + 0.05 * frame);
    const RootFrame root = root_frame(world.topRows<joint_count>());
    PairPose pose;
    pose.topRows<joint_count>() = to_normalized(world.topRows<joint_count>(), root);
    pose.bottomRows<joint_count>() = to_normalized(world.bottomRows<joint_count>(), root);
    columns.sources.push_back({take, frame, false, ActivePerformer::A});
    columns.roots.push_back(root);
    columns.poses.push_back(pose);
    columns.features.push_back(pose_features(pose.topRows<joint_count>()));
    const InteractionMesh mesh = tetrahedralize(pose);
    columns.edges.insert(columns.edges.end(), mesh.edges.begin(), mesh.edges.end());
    columns.tetrahedra.insert(columns.tetrahedra.end(), mesh.tetrahedra.begin(), mesh.tetrahedra.end());
    columns.edge_offsets.push_back(columns.edges.size());
    columns.tetrahedron_offsets.push_back(columns.tetrahedra.size());
    columns.mesh_quality.push_back(0);
  }
}

}  // namespace

std::shared_ptr<const MotionLibrary> two_take_library() {
  LibraryColumns columns;
  columns.name = "small";
  LibraryBody body;
  body.name = "salsa_01/a";
  body.body = body_of(standing_pose());
  body.capsule_radii = generic_capsule_radii();
  columns.bodies = {body};
  columns.edge_offsets = std::vector<std::uint64_t>{0};
  columns.tetrahedron_offsets = std::vector<std::uint64_t>{0};
  add_take(columns, "salsa_01", "turn");
  add_take(columns, "salsa_02", "open_hold");
  return std::make_shared<const MotionLibrary>(std::move(columns));
}

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
