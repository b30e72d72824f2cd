#include "core/synthesis/step/frame_pipeline.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/synthesis/edit/rigid_lengths.hpp"
#include "core/synthesis/frames/frame_room.hpp"

namespace abrazo {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double landed_height_m = 0.03;  ///< toe base above its rest height
constexpr double lowest_foot_m = 0.01;    ///< the floor, for ankles and toes
constexpr double same_length = 1e-9;
/// The moved partner was adapted to the user: the user's own foot locks do not pull it by the mesh again.
constexpr double moved_anchor_weight = 1;
/// Additional clearance of bodies, because they follow the capsule constraints with a lag.
constexpr double parting_clearance_m = 0.02;
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
  if (body && memory_.user.is_given() && are_same_lengths(*body, *memory_.user.body())) return;
  memory_.user = UserMeasure(body);
  memory_.motion.playhead.pair = -1;
  retargeter_.reset();
}

void FramePipeline::set_intent(std::shared_ptr<const IntentModel> model) {
  reserve_room(out_.intent, *model);
  intent_.emplace(std::move(model));
}

void FramePipeline::lose_track() {
  memory_.frames_since_reset = 0;
  memory_.current_pair = -1;
  memory_.previous_heading.reset();
  memory_.locks.reset();
  memory_.motion.playhead.pair = -1;
  memory_.history.clear();
}

void FramePipeline::forget() {
  lose_track();
  memory_.partner_is_shown = false;
  // A frame that fails before the next is solved still holds the pose that was shown.
  if (memory_.shown.is_fitted) memory_.previous += memory_.shown.difference;
  memory_.shown = {};
}

void FramePipeline::restore(const FrameMemory& memory) {
  memory_ = memory;
  retargeter_.reset();  // it is of the user's measures
}

void FramePipeline::take_over(const FrameMemory& memory) {
  restore(memory);
  memory_.current_pair = -1;
  memory_.motion.playhead.pair = -1;
}

bool FramePipeline::measure(const Pose& user, double dt_s) {
  if (next_.user.look_at(user, dt_s)) retargeter_.reset();
  return next_.user.body().has_value();
}

void FramePipeline::retarget(const Pose& user) {
  if (!retargeter_ || retargeter_scales_path_ != settings_.scale_root_path) {
    retargeter_.emplace(*next_.user.body(), library_->usual_active_body().body, settings_.scale_root_path);
    retargeter_scales_path_ = settings_.scale_root_path;
  }
  out_.query_world = retargeter_->apply(user);
  out_.query_root = root_frame(out_.query_world, next_.previous_heading);
  out_.query_normalized = to_normalized(out_.query_world, out_.query_root);
  out_.features = pose_features(out_.query_normalized);
}

bool FramePipeline::is_recorded_foot_slow(int vertex) const {
  if (settings_.foot_lock_speed <= 0) return true;
  int other = library_->later_pair(next_.current_pair, 1);
  if (other < 0) other = library_->later_pair(next_.current_pair, -1);
  if (other < 0) return true;
  const LibraryTake& take = library_->take_of(next_.current_pair);
  const auto world = [&](int pair) -> Vec3 {
    const RootFrame& root = library_->root(pair);
    return root.rotation() * Vec3(library_->pose(pair).row(vertex)) + root.position;
  };
  return (world(other) - world(next_.current_pair)).norm() * take.fps / take.frame_stride <
         settings_.foot_lock_speed;
}

FootLocks::Situations FramePipeline::feet(double dt_s) const {
  FootLocks::Situations situations;
  const Body& active = library_->usual_active_body().body;
  const Body& passive = library_->passive_body(next_.current_pair).body;
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
      slow = is_active ? next_.frames_since_reset > 0 &&
                             (Vec3(next_.previous_query.row(toe_base)) - foot.toe_base).norm() <
                                 settings_.foot_lock_speed * dt_s
                       : is_recorded_foot_slow(toe_base);
    }
    foot.landed = low && slow;
  }
  return situations;
}

RigidDistances FramePipeline::wanted_lengths() const {
  if (plays()) return lengths_as_moved();
  RigidDistances wanted = rigid_distances(out_.selected_pair);
  const Body& active = library_->usual_active_body().body;
  const Body& passive = library_->usual_passive_body().body;
  const Body& recorded_passive = library_->passive_body(next_.current_pair).body;
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

/// The moved partner has the bones that it must have, and a girdle that does not jump.
RigidDistances FramePipeline::lengths_as_moved() const {
  PairPose pair;
  pair << out_.query_world, partner_;
  RigidDistances wanted = rigid_distances(pair);
  const Body& active = library_->usual_active_body().body;
  const Body& passive = library_->usual_passive_body().body;
  for (std::size_t b = 0; b < bone_count; ++b) {
    wanted[b].length_m = active.bone_lengths[b];
    wanted[rigid_distance_count / 2 + b].length_m = passive.bone_lengths[b];
  }
  make_lengths_fit(pair, wanted);
  return wanted;
}

/// What every edit of this frame has.
EditTask FramePipeline::pair_task() const {
  EditTask task;
  task.edges = library_->edges(next_.current_pair);
  task.selected = out_.selected_pair;
  task.reference = out_.selected_pair;
  task.target = out_.query_world;
  task.anchor_weight = settings_.anchor_weight;
  task.floor_m = lowest_foot_m;
  task.active_radii = &library_->usual_active_body().capsule_radii;
  task.passive_radii = &library_->usual_passive_body().capsule_radii;
  return task;
}

EditTask FramePipeline::edit_task(double dt_s) const {
  EditTask task = pair_task();
  task.has_previous = next_.frames_since_reset > 0;
  if (task.has_previous) {
    task.velocity_target =
        settings_.velocity_form == VelocityForm::Predicted ? predicted(dt_s) : next_.previous;
    task.velocity_weight = velocity_weight_at(settings_, dt_s);
  }
  task.wanted = wanted_lengths();
  if (plays()) add_motion(task);
  return task;
}

/// The moved pair, to be parted where the bodies are in one another's way.
EditTask FramePipeline::parting_task(const PairPose& moved) const {
  EditTask task = pair_task();
  task.reference = moved;
  task.wanted = rigid_distances(moved);
  if (next_.partner_is_shown) task.sides = &next_.previous;
  task.clearance_m = parting_clearance_m;
  return task;
}

/// What the moved partner is edited by: its own shape beside the user's, planted feet, held hands.
void FramePipeline::add_motion(EditTask& task) const {
  task.reference << out_.query_world, partner_;
  const FootPlants::Feet& feet = next_.motion.plants.feet();
  for (std::size_t f = 0; f < feet.size(); ++f)
    if (settings_.foot_locks && feet[f].planted) task.planted[f] = feet[f].shown;
  task.holds = out_.holds;
  task.hold_weight = settings_.hold_weight;
  task.keeps_apart = false;
  task.anchor_weight = moved_anchor_weight;
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
    if (memory_.shown.is_fitted) out_.result += memory_.shown.difference;
  } else {
    out_.result = library_->pose(0);
    out_.result.rowwise() += Vec3(0, library_->root(0).position.y(), 0).transpose();
  }
  out_.morph_steps.assign(1, out_.result);
}

void FramePipeline::hold_feet(double dt_s) {
  if (!settings_.foot_locks) return next_.locks.reset();
  next_.locks.update(feet(dt_s), next_.frames_since_reset > 0 ? &next_.previous : nullptr,
                     out_.source_changed);
  if (plays()) next_.locks.release(1);
}

/// A step that failed leaves nothing behind: all that it changed is in `next_`.
void FramePipeline::remember(double dt_s) {
  const PairPose& solved = editor_.result();
  next_.before_previous = next_.frames_since_reset > 0 ? next_.previous : solved;
  next_.previous = solved;
  next_.previous_dt_s = dt_s;
  next_.previous_query = out_.query_world;
  next_.previous_heading = out_.query_root.heading_rad;
  next_.has_good_result = next_.partner_is_shown = true;
  ++next_.frames_since_reset;
  memory_ = next_;
}

/// Clears the previous frame's values, except the poses to hold after a failure.
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
  out_.intent.lead_s = 0;
  out_.intent.partner_place.reset();
  out_.selected_pair.setZero();
  out_.edges.clear();
  out_.tetrahedra.clear();
  out_.edge_weights.clear();
  out_.edge_residuals_m.clear();
  out_.energy = {};
  out_.residual = {};
  out_.foot_locks.clear();
  out_.holds.clear();
  out_.collisions.clear();
  out_.timing = {};
}

void FramePipeline::solve(const Pose& user, double elapsed_s) {
  const double dt_s = elapsed_s > 0 ? std::max(elapsed_s, shortest_step_s) : 0.0;
  const auto start = Clock::now();
  begin_frame();
  next_ = memory_;
  if (next_.motion.moved_by != moving_settings(settings_)) next_.motion.playhead.pair = -1;
  if (!measure(user, dt_s))
    return fail("the user's pose does not have the size of a person; is the unit right?");
  retarget(user);
  out_.timing.retarget_us = microseconds_since(start);

  const auto selecting = Clock::now();
  if (!select(dt_s))
    return fail(selector_.pairs().all_vetoed() ? "every recorded pair is vetoed; lift a veto to go on"
                                               : "no recorded pair could be selected");
  follow_source(dt_s);
  out_.timing.select_us = microseconds_since(selecting);

  const auto meshing = Clock::now();
  const auto edges = library_->edges(next_.current_pair);
  const auto tetrahedra = library_->tetrahedra(next_.current_pair);
  out_.edges.assign(edges.begin(), edges.end());
  out_.tetrahedra.assign(tetrahedra.begin(), tetrahedra.end());
  out_.timing.mesh_us = microseconds_since(meshing);

  const auto solving = Clock::now();
  if (plays() && !move(dt_s))
    return fail("the selected pair could not be brought to the user; the last poses are held");
  hold_feet(dt_s);
  const auto outcome = editor_.edit(edit_task(dt_s), settings_, next_.locks);
  if (!outcome.solved)
    return fail("the constraints of this frame contradict one another; the last poses are held");
  report(outcome);
  show(user, dt_s);
  out_.timing.solve_us = microseconds_since(solving);

  remember(dt_s);
  out_.timing.total_us = microseconds_since(start);
}

}  // namespace abrazo
