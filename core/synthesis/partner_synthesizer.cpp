#include "core/synthesis/partner_synthesizer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>

#include "core/retarget/body_retargeter.hpp"
#include "core/selection/pair_selector.hpp"
#include "core/synthesis/pair_editor.hpp"
#include "core/synthesis/transition.hpp"

namespace abrazo {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double tracking_loss_s = 0.3;
constexpr double landed_height_m = 0.03;  ///< toe base above its rest height
constexpr double lowest_foot_m = 0.01;    ///< the floor, for ankles and toes
constexpr double same_length = 1e-9;
constexpr double hold_distance_m = 0.13;  ///< hand ends closer than this hold one another
constexpr double hold_hurry = 4.0;

double microseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

Result<std::vector<int>> selectable_pairs(const MotionLibrary& library,
                                          const std::vector<std::string>& excluded) {
  std::vector<bool> is_excluded(library.takes().size(), false);
  for (const std::string& name : excluded) {
    const int take = library.find_take(name);
    if (take < 0) {
      std::string names;
      for (const LibraryTake& known : library.takes()) names += (names.empty() ? "" : ", ") + known.name;
      return Error{"the library has no take of this name to leave out; it has " + names, name};
    }
    is_excluded[static_cast<std::size_t>(take)] = true;
  }
  std::vector<int> pairs;
  for (int pair = 0; pair < library.pair_count(); ++pair)
    if (!is_excluded[library.source(pair).take]) pairs.push_back(pair);
  if (pairs.empty()) return Error{"no pair is left to select from: every take is left out", library.name()};
  return pairs;
}

/// Whole frames of the library that fit into a step, at least one.
int expected_advance(const LibraryTake& take, double dt_s) {
  return std::max(1, static_cast<int>(std::lround(dt_s * take.fps / take.frame_stride)));
}

}  // namespace

struct PartnerSynthesizer::State {
  State(std::shared_ptr<const MotionLibrary> motion_library, const Settings& start, std::vector<int> pairs)
      : library(std::move(motion_library)), settings(start), selector(library, std::move(pairs)) {}

  std::shared_ptr<const MotionLibrary> library;
  Settings settings;
  PairSelector selector;
  PairEditor editor;
  FootLocks locks;
  Transition transition;
  std::optional<Body> user_body;
  std::optional<BodyRetargeter> retargeter;
  bool retargeter_scales_path = true;
  std::optional<int> pinned;

  int frames_since_reset = 0;
  PairPose previous = PairPose::Zero();         ///< V'_{i-1}
  PairPose before_previous = PairPose::Zero();  ///< V'_{i-2}
  double previous_dt_s = 0;
  Pose previous_query = Pose::Zero();
  std::optional<double> previous_heading;
  int current_pair = -1;
  bool has_good_result = false;

  FrameResult out;

  void forget();
  void solve(const Pose& user, double dt_s);
  void retarget(const Pose& user);
  bool select(double dt_s);
  void follow_source(double dt_s);
  std::array<double, joint_count> hurry_of_holds() const;
  EditTask edit_task(double dt_s) const;
  FootLocks::Situations feet(double dt_s) const;
  bool is_recorded_foot_slow(int vertex) const;
  RigidDistances wanted_lengths() const;
  void report(const PairEditor::Outcome& outcome);
  void fail(const std::string& why);
  PairPose predicted(double dt_s) const;
  Pose partner_velocity(int pair) const;
};

void PartnerSynthesizer::State::forget() {
  frames_since_reset = 0;
  current_pair = -1;
  previous_heading.reset();
  locks.reset();
  transition.reset();
}

void PartnerSynthesizer::State::retarget(const Pose& user) {
  if (!user_body) user_body = body_of(user);
  if (!retargeter || retargeter_scales_path != settings.scale_root_path) {
    retargeter.emplace(*user_body, library->usual_active_body().body, settings.scale_root_path);
    retargeter_scales_path = settings.scale_root_path;
  }
  out.query_world = retargeter->apply(user);
  out.query_root = root_frame(out.query_world, previous_heading);
  out.query_normalized = to_normalized(out.query_world, out.query_root);
  out.features = pose_features(out.query_normalized);
}

/// Eq. 3-4, with the velocity over the time that passed.
PairPose PartnerSynthesizer::State::predicted(double dt_s) const {
  if (frames_since_reset < 2 || previous_dt_s <= 0) return previous;
  return previous + (dt_s / previous_dt_s) * (previous - before_previous);
}

bool PartnerSynthesizer::State::select(double dt_s) {
  SelectionQuery query;
  query.normalized = out.query_normalized;
  query.root = out.query_root;
  query.features = out.features;
  query.has_prediction = frames_since_reset > 0;
  query.predicted = predicted(dt_s);
  query.alpha = settings.alpha;
  query.neighbours = settings.neighbours;
  query.current_pair = current_pair;
  query.continuations = settings.continuations;
  if (current_pair >= 0) query.expected_advance = expected_advance(library->take_of(current_pair), dt_s);
  out.selected = selector.select(query, out.candidates);
  if (pinned && *pinned >= 0 && *pinned < library->pair_count()) {
    const auto at = std::find_if(out.candidates.begin(), out.candidates.end(),
                                 [&](const Candidate& c) { return c.pair == *pinned; });
    if (at != out.candidates.end()) {
      out.selected = static_cast<int>(at - out.candidates.begin());
    } else {
      Candidate candidate;
      candidate.pair = *pinned;
      candidate.feature_distance = (library->features(*pinned) - out.features).norm();
      candidate.cost =
          pair_cost(query, library->pose(*pinned), pair_in_world(*library, *pinned, out.query_root));
      const auto place = std::upper_bound(
          out.candidates.begin(), out.candidates.end(), candidate,
          [](const Candidate& a, const Candidate& b) { return a.feature_distance < b.feature_distance; });
      out.selected = static_cast<int>(out.candidates.insert(place, candidate) - out.candidates.begin());
    }
  }
  return out.selected >= 0;
}

/// Velocity of the recorded partner relative to the user's root [m/s].
Pose PartnerSynthesizer::State::partner_velocity(int pair) const {
  const int next = library->later_pair(pair, 1);
  if (next < 0) return Pose::Zero();
  const LibraryTake& take = library->take_of(pair);
  const double dt = take.frame_stride / take.fps;
  return (pair_in_world(*library, next, out.query_root) - pair_in_world(*library, pair, out.query_root))
             .bottomRows<joint_count>() /
         dt;
}

/// The partner's arms that hold a hand in the selected pair get there sooner than the body.
std::array<double, joint_count> PartnerSynthesizer::State::hurry_of_holds() const {
  std::array<double, joint_count> hurry{};
  hurry.fill(1.0);
  for (const int hand : {joints::left_hand, joints::right_hand}) {
    const auto passive_hand = out.selected_pair.row(hand + joint_count);
    const bool holds = (out.selected_pair.row(joints::left_hand) - passive_hand).norm() < hold_distance_m ||
                       (out.selected_pair.row(joints::right_hand) - passive_hand).norm() < hold_distance_m;
    if (!holds) continue;
    const auto arm = static_cast<std::size_t>(hand);
    hurry[arm] = hurry[arm - 1] = hold_hurry;
    hurry[arm - 2] = 0.5 * hold_hurry;
  }
  return hurry;
}

/// Notices when the selected pair does not continue the previous one, and lets the partner glide over.
void PartnerSynthesizer::State::follow_source(double dt_s) {
  const int pair = out.candidates[static_cast<std::size_t>(out.selected)].pair;
  out.selected_pair = pair_in_world(*library, pair, out.query_root);
  transition.fade(dt_s, settings.transition_half_life_s, hurry_of_holds());
  out.source_changed = false;
  if (current_pair >= 0) {
    const int advance = expected_advance(library->take_of(current_pair), dt_s);
    const PairSource& now = library->source(pair);
    const PairSource& before = library->source(current_pair);
    const int frames = static_cast<int>(now.frame) - static_cast<int>(before.frame);
    // Within twice the expected pace either way it is still the same stretch of recorded motion.
    out.source_changed = now.take != before.take || now.swapped != before.swapped ||
                         std::abs(frames - advance * library->take_of(pair).frame_stride) >
                             std::max(2, 2 * advance * library->take_of(pair).frame_stride);
    const int continued = library->later_pair(current_pair, advance);
    if (settings.transition_half_life_s > 0 && pair != continued) {
      const Pose chosen = out.selected_pair.bottomRows<joint_count>();
      const int from = continued >= 0 ? continued : current_pair;
      const Pose would_be = pair_in_world(*library, from, out.query_root).bottomRows<joint_count>();
      transition.jump(would_be, partner_velocity(from), chosen, partner_velocity(pair));
    }
  }
  current_pair = pair;
}

bool PartnerSynthesizer::State::is_recorded_foot_slow(int vertex) const {
  if (settings.foot_lock_speed <= 0) return true;
  int other = library->later_pair(current_pair, 1);
  if (other < 0) other = library->later_pair(current_pair, -1);
  if (other < 0) return true;
  const LibraryTake& take = library->take_of(current_pair);
  const auto world = [&](int pair) -> Vec3 {
    const RootFrame& root = library->root(pair);
    return root.rotation() * Vec3(library->pose(pair).row(vertex)) + root.position;
  };
  return (world(other) - world(current_pair)).norm() * take.fps / take.frame_stride <
         settings.foot_lock_speed;
}

FootLocks::Situations PartnerSynthesizer::State::feet(double dt_s) const {
  FootLocks::Situations situations;
  const Body& active = library->usual_active_body().body;
  const Body& passive = library->passive_body(current_pair).body;
  for (std::size_t f = 0; f < situations.size(); ++f) {
    const int toe_base = FootLocks::ankles[f] + 1;
    const int hip = FootLocks::ankles[f] - 2;
    FootSituation& foot = situations[f];
    const bool is_active = f < 2;
    const Body& body = is_active ? active : passive;
    foot.toe_base = is_active ? Vec3(out.query_world.row(toe_base)) : Vec3(out.selected_pair.row(toe_base));
    foot.hip = is_active ? Vec3(out.query_world.row(hip)) : Vec3(out.selected_pair.row(hip));
    foot.leg_length = library->usual_active_body().body.leg_length();
    if (!is_active) foot.leg_length = library->usual_passive_body().body.leg_length();
    const bool low = foot.toe_base.y() < body.toe_rest_height + landed_height_m;
    bool slow = true;
    if (settings.foot_lock_speed > 0) {
      slow = is_active
                 ? frames_since_reset > 0 && (Vec3(previous_query.row(toe_base)) - foot.toe_base).norm() <
                                                 settings.foot_lock_speed * dt_s
                 : is_recorded_foot_slow(toe_base);
    }
    foot.landed = low && slow;
  }
  return situations;
}

RigidDistances PartnerSynthesizer::State::wanted_lengths() const {
  RigidDistances wanted = rigid_distances(out.selected_pair);
  const Body& active = library->usual_active_body().body;
  const Body& passive = library->usual_passive_body().body;
  const Body& recorded_passive = library->passive_body(current_pair).body;
  PairPose with_query = out.selected_pair;
  with_query.topRows<joint_count>() = out.query_world;
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
  return wanted;
}

EditTask PartnerSynthesizer::State::edit_task(double dt_s) const {
  EditTask task;
  task.edges = library->edges(current_pair);
  task.selected = out.selected_pair;
  task.reference_offset = transition.offset();
  task.target = out.query_world;
  task.has_previous = frames_since_reset > 0;
  if (task.has_previous) {
    task.velocity_target = settings.velocity_form == VelocityForm::Predicted ? predicted(dt_s) : previous;
    task.velocity_weight = velocity_weight_at(settings, dt_s);
  }
  task.wanted = wanted_lengths();
  task.floor_m = lowest_foot_m;
  task.active_radii = &library->usual_active_body().capsule_radii;
  task.passive_radii = &library->usual_passive_body().capsule_radii;
  return task;
}

void PartnerSynthesizer::State::report(const PairEditor::Outcome& outcome) {
  using Relaxation = PairEditor::Relaxation;
  out.result = editor.result();
  out.morph_steps.assign(editor.steps().begin(), editor.steps().end());
  out.status = outcome.relaxation == Relaxation::None ? StepStatus::Ok : StepStatus::Relaxed;
  switch (outcome.relaxation) {
    case Relaxation::None:
      out.message.clear();
      break;
    case Relaxation::PassiveFeet:
      out.message = "the partner's foot locks were let go";
      break;
    case Relaxation::Feet:
      out.message = "all foot locks were let go";
      break;
    case Relaxation::Capsules:
      out.message = "foot locks and collisions were let go";
      break;
    case Relaxation::Everything:
      out.message = "only bone lengths were kept";
      break;
  }
  const EditTask& task = editor.task();
  const Laplacian& laplacian = editor.laplacian();
  out.energy.deformation = laplacian.deformation_energy(out.result, out.selected_pair);
  out.energy.velocity = task.has_previous ? 0.5 * (out.result - task.velocity_target).squaredNorm() : 0.0;
  const double morph_sq = (out.result.topRows<joint_count>() - out.query_world).squaredNorm();
  out.energy.constraint = 0.5 * settings.morph_weight * morph_sq;
  out.residual.morph_rms_m = std::sqrt(morph_sq / joint_count);
  out.residual.bone_length_max = bone_length_error(out.result, task.wanted);
  const int locked_bodies = !settings.foot_locks || outcome.relaxation >= Relaxation::Feet ? 0
                            : outcome.relaxation == Relaxation::PassiveFeet                ? 1
                                                                                           : 2;
  locks.list(locked_bodies, out.foot_locks);
  out.residual.foot_lock_max_m = locks.drift(locked_bodies, out.result);
  editor.contacts().measure(out.result, out.collisions, out.residual.penetration_max_m,
                            out.residual.excess_penetration_max_m);

  const PairPose residuals = laplacian.apply(out.result - out.selected_pair);
  out.edge_weights.clear();
  out.edge_residuals_m.clear();
  for (const MeshEdge& edge : out.edges) {
    out.edge_weights.push_back(0.5 *
                               (laplacian.weight(edge[0], edge[1]) + laplacian.weight(edge[1], edge[0])));
    out.edge_residuals_m.push_back(0.5 * (residuals.row(edge[0]).norm() + residuals.row(edge[1]).norm()));
  }
}

void PartnerSynthesizer::State::fail(const std::string& why) {
  out.status = StepStatus::Failed;
  out.message = why;
  out.foot_locks.clear();
  out.collisions.clear();
  out.residual = {};
  out.energy = {};
  if (has_good_result) {
    out.result = previous;
  } else {
    out.result = library->pose(0);
    out.result.rowwise() += Vec3(0, library->root(0).position.y(), 0).transpose();
  }
  out.morph_steps.assign(1, out.result);
}

void PartnerSynthesizer::State::solve(const Pose& user, double dt_s) {
  const auto start = Clock::now();
  out.timing = {};
  retarget(user);
  out.timing.retarget_us = microseconds_since(start);

  const auto selecting = Clock::now();
  if (!select(dt_s)) return fail("no recorded pair could be selected");
  follow_source(dt_s);
  out.timing.select_us = microseconds_since(selecting);

  const auto meshing = Clock::now();
  const auto edges = library->edges(current_pair);
  const auto tetrahedra = library->tetrahedra(current_pair);
  out.edges.assign(edges.begin(), edges.end());
  out.tetrahedra.assign(tetrahedra.begin(), tetrahedra.end());
  out.timing.mesh_us = microseconds_since(meshing);

  const auto solving = Clock::now();
  locks.update(feet(dt_s), frames_since_reset > 0 ? &previous : nullptr, out.source_changed);
  if (settings.transition_half_life_s > 0 && settings.foot_locks)
    for (std::size_t f = 0; f < 2; ++f) {
      if (!locks.passive_released()[f]) continue;
      for (int vertex = FootLocks::ankles[2 + f]; vertex < FootLocks::ankles[2 + f] + 3; ++vertex)
        transition.pull(vertex - joint_count, previous.row(vertex), out.selected_pair.row(vertex));
    }
  const auto outcome = editor.edit(edit_task(dt_s), settings, locks);
  if (!outcome.solved)
    return fail("the constraints of this frame contradict one another; the last poses are held");
  report(outcome);
  out.timing.solve_us = microseconds_since(solving);

  before_previous = frames_since_reset > 0 ? previous : out.result;
  previous = out.result;
  previous_dt_s = dt_s;
  previous_query = out.query_world;
  previous_heading = out.query_root.heading_rad;
  has_good_result = true;
  ++frames_since_reset;
  out.timing.total_us = microseconds_since(start);
}

Result<std::unique_ptr<PartnerSynthesizer>> PartnerSynthesizer::create(
    std::shared_ptr<const MotionLibrary> library, const Settings& settings,
    const std::vector<std::string>& excluded_takes) {
  auto pairs = selectable_pairs(*library, excluded_takes);
  if (!pairs) return pairs.error();
  auto state = std::make_unique<State>(std::move(library), settings, std::move(*pairs));
  return std::unique_ptr<PartnerSynthesizer>(new PartnerSynthesizer(std::move(state)));
}

PartnerSynthesizer::PartnerSynthesizer(std::unique_ptr<State> state) : state_(std::move(state)) {}
PartnerSynthesizer::~PartnerSynthesizer() = default;

const FrameResult& PartnerSynthesizer::step(const Pose& user, Duration elapsed) {
  State& state = *state_;
  const double dt_s = elapsed.count();
  try {
    if (!user.allFinite()) {
      int joint = 0;
      while (joint + 1 < joint_count && user.row(joint).allFinite()) ++joint;
      state.fail("the user's pose has no finite position for " +
                 std::string(joint_names[static_cast<std::size_t>(joint)]));
      state.out.candidates.clear();
      state.out.selected = -1;
      return state.out;
    }
    if (!(dt_s > 0) || dt_s > tracking_loss_s) state.forget();
    state.solve(user, dt_s > 0 ? dt_s : 0.0);
  } catch (const std::exception& failure) {
    state.fail(failure.what());
  }
  return state.out;
}

void PartnerSynthesizer::set_settings(const Settings& settings) {
  state_->settings = settings;
}
const Settings& PartnerSynthesizer::settings() const {
  return state_->settings;
}

void PartnerSynthesizer::set_user_body(const Body& body) {
  state_->user_body = body;
  state_->retargeter.reset();
}

void PartnerSynthesizer::reset() {
  state_->forget();
}
void PartnerSynthesizer::pin_pair(std::optional<int> pair) {
  state_->pinned = pair;
}
const MotionLibrary& PartnerSynthesizer::library() const {
  return *state_->library;
}

}  // namespace abrazo
