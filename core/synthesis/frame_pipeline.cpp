#include "core/synthesis/frame_pipeline.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/synthesis/frame_room.hpp"
#include "core/synthesis/rigid_lengths.hpp"

namespace abrazo {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double landed_height_m = 0.03;  ///< toe base above its rest height
constexpr double lowest_foot_m = 0.01;    ///< the floor, for ankles and toes
constexpr double same_length = 1e-9;
constexpr double smallest_user_m = 0.3;
constexpr double largest_user_m = 3.5;
constexpr double shortest_step_s = 1.0 / 240;  ///< closer poses would make velocities out of noise

double microseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

}  // namespace

FramePipeline::FramePipeline(std::shared_ptr<const MotionLibrary> library, const Settings& settings,
                             std::vector<int> pairs, std::shared_ptr<const PoseIndex> index)
    : library_(std::move(library)),
      settings_(settings),
      selector_(library_, std::move(pairs), std::move(index)) {
  reserve_room(out_);
}

void FramePipeline::set_user_body(const std::optional<Body>& body) {
  memory_.user_body = body;
  retargeter_.reset();
}

void FramePipeline::set_intent(std::shared_ptr<const IntentModel> model) {
  reserve_room(out_.intent, *model);
  intent_.emplace(std::move(model));
}

void FramePipeline::forget() {
  memory_.frames_since_reset = 0;
  memory_.current_pair = -1;
  memory_.previous_heading.reset();
  memory_.locks.reset();
  memory_.transition.reset();
  memory_.history.clear();
}

void FramePipeline::restore(const FrameMemory& memory) {
  memory_ = memory;
  retargeter_.reset();  // it is of the user's measures
}

void FramePipeline::take_over(const FrameMemory& memory) {
  restore(memory);
  memory_.current_pair = -1;
}

bool FramePipeline::measure(const Pose& user) {
  if (memory_.user_body) return true;
  const Body body = body_of(user);
  const double height = body.height();
  const bool plausible =
      height > smallest_user_m &&
      height<largest_user_m&& * std::min_element(body.bone_lengths.begin(), body.bone_lengths.end())> 1e-4;
  if (plausible) memory_.user_body = body;
  return plausible;
}

void FramePipeline::retarget(const Pose& user) {
  if (!retargeter_ || retargeter_scales_path_ != settings_.scale_root_path) {
    retargeter_.emplace(*memory_.user_body, library_->usual_active_body().body, settings_.scale_root_path);
    retargeter_scales_path_ = settings_.scale_root_path;
  }
  out_.query_world = retargeter_->apply(user);
  out_.query_root = root_frame(out_.query_world, memory_.previous_heading);
  out_.query_normalized = to_normalized(out_.query_world, out_.query_root);
  out_.features = pose_features(out_.query_normalized);
}

bool FramePipeline::is_recorded_foot_slow(int vertex) const {
  if (settings_.foot_lock_speed <= 0) return true;
  int other = library_->later_pair(memory_.current_pair, 1);
  if (other < 0) other = library_->later_pair(memory_.current_pair, -1);
  if (other < 0) return true;
  const LibraryTake& take = library_->take_of(memory_.current_pair);
  const auto world = [&](int pair) -> Vec3 {
    const RootFrame& root = library_->root(pair);
    return root.rotation() * Vec3(library_->pose(pair).row(vertex)) + root.position;
  };
  return (world(other) - world(memory_.current_pair)).norm() * take.fps / take.frame_stride <
         settings_.foot_lock_speed;
}

FootLocks::Situations FramePipeline::feet(double dt_s) const {
  FootLocks::Situations situations;
  const Body& active = library_->usual_active_body().body;
  const Body& passive = library_->passive_body(memory_.current_pair).body;
  for (std::size_t f = 0; f < situations.size(); ++f) {
    const int toe_base = FootLocks::ankles[f] + 1;
    const int hip = FootLocks::ankles[f] - 2;
    FootSituation& foot = situations[f];
    const bool is_active = f < 2;
    const Body& body = is_active ? active : passive;
    foot.toe_base = is_active ? Vec3(out_.query_world.row(toe_base)) : Vec3(out_.selected_pair.row(toe_base));
    foot.hip = is_active ? Vec3(out_.query_world.row(hip)) : Vec3(out_.selected_pair.row(hip));
    foot.leg_length =
        (is_active ? library_->usual_active_body() : library_->usual_passive_body()).body.leg_length();
    const bool low = foot.toe_base.y() < body.toe_rest_height + landed_height_m;
    bool slow = true;
    if (settings_.foot_lock_speed > 0) {
      slow = is_active ? memory_.frames_since_reset > 0 &&
                             (Vec3(memory_.previous_query.row(toe_base)) - foot.toe_base).norm() <
                                 settings_.foot_lock_speed * dt_s
                       : is_recorded_foot_slow(toe_base);
    }
    foot.landed = low && slow;
  }
  return situations;
}

RigidDistances FramePipeline::wanted_lengths() const {
  RigidDistances wanted = rigid_distances(out_.selected_pair);
  const Body& active = library_->usual_active_body().body;
  const Body& passive = library_->usual_passive_body().body;
  const Body& recorded_passive = library_->passive_body(memory_.current_pair).body;
  PairPose with_query = out_.selected_pair;
  with_query.topRows<joint_count>() = out_.query_world;
  const RigidDistances of_query = rigid_distances(with_query);
  constexpr std::size_t per_body = rigid_distance_count / 2;
  for (std::size_t b = 0; b < bone_count; ++b) {
    wanted[b].length_m = active.bone_lengths[b];
    wanted[per_body + b].length_m = passive.bone_lengths[b];
  }
  // Pelvis and girdle are rigid in some skeletons only: what they are in the user's and the recorded pose.
  for (std::size_t p = 0; p < pseudo_bones.size(); ++p) {
    const std::size_t at = bone_count + p;
    wanted[at].length_m = of_query[at].length_m;
    const double recorded = recorded_passive.pseudo_lengths[p];
    if (recorded > same_length) wanted[per_body + at].length_m *= passive.pseudo_lengths[p] / recorded;
  }
  make_lengths_fit(with_query, wanted);
  return wanted;
}

EditTask FramePipeline::edit_task(double dt_s) const {
  EditTask task;
  task.edges = library_->edges(memory_.current_pair);
  task.selected = out_.selected_pair;
  task.reference_offset = memory_.transition.offset();
  task.target = out_.query_world;
  task.has_previous = memory_.frames_since_reset > 0;
  if (task.has_previous) {
    task.velocity_target =
        settings_.velocity_form == VelocityForm::Predicted ? predicted(dt_s) : memory_.previous;
    task.velocity_weight = velocity_weight_at(settings_, dt_s);
  }
  task.wanted = wanted_lengths();
  task.floor_m = lowest_foot_m;
  task.active_radii = &library_->usual_active_body().capsule_radii;
  task.passive_radii = &library_->usual_passive_body().capsule_radii;
  return task;
}

void FramePipeline::refuse(std::string_view why, std::string_view where) {
  begin_frame();
  fail(why, where);
}

void FramePipeline::fail(std::string_view why, std::string_view where) {
  out_.status = StepStatus::Failed;
  out_.message.assign(why).append(where);
  if (memory_.has_good_result) {
    out_.result = memory_.previous;
  } else {
    out_.result = library_->pose(0);
    out_.result.rowwise() += Vec3(0, library_->root(0).position.y(), 0).transpose();
  }
  out_.morph_steps.assign(1, out_.result);
}

void FramePipeline::hold_feet(double dt_s) {
  if (!settings_.foot_locks) return memory_.locks.reset();
  memory_.locks.update(feet(dt_s), memory_.frames_since_reset > 0 ? &memory_.previous : nullptr,
                       out_.source_changed);
  if (settings_.transition_half_life_s > 0)
    for (std::size_t f = 0; f < 2; ++f) {
      if (!memory_.locks.passive_released()[f]) continue;
      for (int vertex = FootLocks::ankles[2 + f]; vertex < FootLocks::ankles[2 + f] + 3; ++vertex)
        memory_.transition.pull(vertex - joint_count, memory_.previous.row(vertex),
                                out_.selected_pair.row(vertex));
    }
}

void FramePipeline::remember(double dt_s) {
  memory_.before_previous = memory_.frames_since_reset > 0 ? memory_.previous : out_.result;
  memory_.previous = out_.result;
  memory_.previous_dt_s = dt_s;
  memory_.previous_query = out_.query_world;
  memory_.previous_heading = out_.query_root.heading_rad;
  memory_.history = history_;
  memory_.has_good_result = true;
  ++memory_.frames_since_reset;
}

/// Nothing of the previous frame is left to be taken for this one's, but the poses that are held when it
/// fails.
void FramePipeline::begin_frame() {
  out_.query_world.setZero();
  out_.query_normalized.setZero();
  out_.features.setZero();
  out_.query_root = {};
  out_.candidates.clear();
  out_.selected = -1;
  out_.source_changed = false;
  out_.intent.model.reset();
  out_.intent.belief.clear();
  out_.intent.moves.clear();
  out_.intent.continued = -1;
  out_.selected_pair.setZero();
  out_.edges.clear();
  out_.tetrahedra.clear();
  out_.edge_weights.clear();
  out_.edge_residuals_m.clear();
  out_.energy = {};
  out_.residual = {};
  out_.foot_locks.clear();
  out_.collisions.clear();
  out_.timing = {};
}

void FramePipeline::solve(const Pose& user, double elapsed_s) {
  const double dt_s = elapsed_s > 0 ? std::max(elapsed_s, shortest_step_s) : 0.0;
  const auto start = Clock::now();
  begin_frame();
  if (!measure(user)) return fail("the user's pose does not have the size of a person; is the unit right?");
  retarget(user);
  out_.timing.retarget_us = microseconds_since(start);

  const auto selecting = Clock::now();
  if (!select(dt_s))
    return fail(selector_.pairs().all_vetoed() ? "every recorded pair is vetoed; lift a veto to go on"
                                               : "no recorded pair could be selected");
  follow_source(dt_s);
  out_.timing.select_us = microseconds_since(selecting);

  const auto meshing = Clock::now();
  const auto edges = library_->edges(memory_.current_pair);
  const auto tetrahedra = library_->tetrahedra(memory_.current_pair);
  out_.edges.assign(edges.begin(), edges.end());
  out_.tetrahedra.assign(tetrahedra.begin(), tetrahedra.end());
  out_.timing.mesh_us = microseconds_since(meshing);

  const auto solving = Clock::now();
  hold_feet(dt_s);
  const auto outcome = editor_.edit(edit_task(dt_s), settings_, memory_.locks);
  if (!outcome.solved)
    return fail("the constraints of this frame contradict one another; the last poses are held");
  report(outcome);
  out_.timing.solve_us = microseconds_since(solving);

  remember(dt_s);
  out_.timing.total_us = microseconds_since(start);
}

}  // namespace abrazo
