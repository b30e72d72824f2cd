#include "core/synthesis/frame_pipeline.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/mesh/capsules.hpp"
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
constexpr double hold_hurry = 4.0;

double microseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

/// Whole frames of the library that fit into a step, at least one.
int expected_advance(const LibraryTake& take, double dt_s) {
  return std::max(1, static_cast<int>(std::lround(dt_s * take.fps / take.frame_stride)));
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

void FramePipeline::forget() {
  memory_.frames_since_reset = 0;
  memory_.current_pair = -1;
  memory_.previous_heading.reset();
  memory_.locks.reset();
  memory_.transition.reset();
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

/// Eq. 3-4, with the velocity over the time that passed.
PairPose FramePipeline::predicted(double dt_s) const {
  if (memory_.frames_since_reset < 2 || memory_.previous_dt_s <= 0) return memory_.previous;
  return memory_.previous + (dt_s / memory_.previous_dt_s) * (memory_.previous - memory_.before_previous);
}

bool FramePipeline::select(double dt_s) {
  SelectionQuery query;
  query.normalized = out_.query_normalized;
  query.root = out_.query_root;
  query.features = out_.features;
  query.has_prediction = memory_.frames_since_reset > 0;
  query.predicted = predicted(dt_s);
  query.alpha = settings_.alpha;
  query.neighbours = settings_.neighbours;
  query.current_pair = memory_.current_pair;
  query.continuations = settings_.continuations;
  if (memory_.current_pair >= 0)
    query.expected_advance = expected_advance(library_->take_of(memory_.current_pair), dt_s);
  out_.selected = selector_.select(query, out_.candidates);
  if (pinned_ && *pinned_ >= 0 && *pinned_ < library_->pair_count() && selector_.is_selectable(*pinned_))
    select_pinned(query);
  return out_.selected >= 0;
}

void FramePipeline::select_pinned(const SelectionQuery& query) {
  const auto at = std::find_if(out_.candidates.begin(), out_.candidates.end(),
                               [&](const Candidate& c) { return c.pair == *pinned_; });
  if (at != out_.candidates.end()) {
    out_.selected = static_cast<int>(at - out_.candidates.begin());
    return;
  }
  Candidate candidate;
  candidate.pair = *pinned_;
  candidate.feature_distance = (library_->features(*pinned_) - out_.features).norm();
  candidate.cost =
      pair_cost(query, library_->pose(*pinned_), library_->pair_in_world(*pinned_, out_.query_root));
  const auto place = std::upper_bound(
      out_.candidates.begin(), out_.candidates.end(), candidate,
      [](const Candidate& a, const Candidate& b) { return a.feature_distance < b.feature_distance; });
  out_.selected = static_cast<int>(place - out_.candidates.begin());  // insert may move them all
  out_.candidates.insert(place, candidate);
}

/// Velocity of the recorded partner relative to the user's root [m/s].
Pose FramePipeline::partner_velocity(int pair) const {
  const int next = library_->later_pair(pair, 1);
  if (next < 0) return Pose::Zero();
  const LibraryTake& take = library_->take_of(pair);
  const double dt = take.frame_stride / take.fps;
  return (library_->pair_in_world(next, out_.query_root) - library_->pair_in_world(pair, out_.query_root))
             .bottomRows<joint_count>() /
         dt;
}

/// The partner's arms that hold a hand in the selected pair get there sooner than the body.
std::array<double, joint_count> FramePipeline::hurry_of_holds() const {
  std::array<double, joint_count> hurry{};
  hurry.fill(1.0);
  for (const int hand : {joints::left_hand, joints::right_hand}) {
    const auto passive_hand = out_.selected_pair.row(hand + joint_count);
    const bool holds = (out_.selected_pair.row(joints::left_hand) - passive_hand).norm() < hold_distance_m ||
                       (out_.selected_pair.row(joints::right_hand) - passive_hand).norm() < hold_distance_m;
    if (!holds) continue;
    const auto arm = static_cast<std::size_t>(hand);
    hurry[arm] = hurry[arm - 1] = hold_hurry;
    hurry[arm - 2] = 0.5 * hold_hurry;
  }
  return hurry;
}

/// Notices when the selected pair does not continue the previous one, and lets the partner glide over.
void FramePipeline::follow_source(double dt_s) {
  const int pair = out_.candidates[static_cast<std::size_t>(out_.selected)].pair;
  out_.selected_pair = library_->pair_in_world(pair, out_.query_root);
  memory_.transition.fade(dt_s, settings_.transition_half_life_s, hurry_of_holds());
  out_.source_changed = false;
  if (memory_.current_pair >= 0)
    glide_from_continued(pair, dt_s);
  else if (memory_.frames_since_reset > 0)
    glide_from_prediction(pair, dt_s);
  memory_.current_pair = pair;
}

void FramePipeline::glide_from_continued(int pair, double dt_s) {
  const int advance = expected_advance(library_->take_of(memory_.current_pair), dt_s);
  const PairSource& now = library_->source(pair);
  const PairSource& before = library_->source(memory_.current_pair);
  const int frames = static_cast<int>(now.frame) - static_cast<int>(before.frame);
  // From standing still to three times the expected pace it is still the same stretch of recorded motion.
  const int most = std::max(3, 3 * advance * library_->take_of(pair).frame_stride);
  out_.source_changed =
      now.take != before.take || now.swapped != before.swapped || frames < 0 || frames > most;
  const int continued = library_->later_pair(memory_.current_pair, advance);
  if (settings_.transition_half_life_s <= 0 || pair == continued) return;
  const Pose chosen = out_.selected_pair.bottomRows<joint_count>();
  const int from = continued >= 0 ? continued : memory_.current_pair;
  const Pose would_be = library_->pair_in_world(from, out_.query_root).bottomRows<joint_count>();
  memory_.transition.jump(would_be, partner_velocity(from), chosen, partner_velocity(pair));
}

/// The partner goes on without a recorded pair that did: from where its own motion would have taken it.
void FramePipeline::glide_from_prediction(int pair, double dt_s) {
  out_.source_changed = true;
  if (settings_.transition_half_life_s <= 0) return;
  Pose velocity = Pose::Zero();
  if (memory_.frames_since_reset >= 2 && memory_.previous_dt_s > 0)
    velocity = (memory_.previous - memory_.before_previous).bottomRows<joint_count>() / memory_.previous_dt_s;
  memory_.transition.reset();  // what was left of it is in the prediction
  memory_.transition.jump(predicted(dt_s).bottomRows<joint_count>(), velocity,
                          out_.selected_pair.bottomRows<joint_count>(), partner_velocity(pair));
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
    return fail(selector_.all_vetoed() ? "every recorded pair is vetoed; lift a veto to go on"
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
