#include "widgets/plots/plot_series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/units.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/metrics/holds.hpp"
#include "core/metrics/partner_error.hpp"

namespace abrazo::widgets {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

void read_timings(const StepTiming& timing, SeriesValues& values) {
  constexpr double ms_per_us = 1e-3;
  at(values, Series::RetargetTime) = ms_per_us * timing.retarget_us;
  at(values, Series::SelectTime) = ms_per_us * timing.select_us;
  at(values, Series::MeshTime) = ms_per_us * timing.mesh_us;
  at(values, Series::SolveTime) = ms_per_us * timing.solve_us;
  at(values, Series::TotalTime) = ms_per_us * timing.total_us;
}

void read_residuals(const FrameResidual& residual, SeriesValues& values) {
  at(values, Series::BoneLength) = 100 * residual.bone_length_max;
  at(values, Series::FootLock) = mm_per_m * residual.foot_lock_max_m;
  at(values, Series::Penetration) = mm_per_m * residual.penetration_max_m;
  at(values, Series::ExcessPenetration) = mm_per_m * residual.excess_penetration_max_m;
  at(values, Series::MorphRms) = mm_per_m * residual.morph_rms_m;
}

void read_intent_cost(const IntentCost& cost, SeriesValues& values) {
  at(values, Series::ExpectedPartner) = cost.partner;
  at(values, Series::LeaderMotion) = cost.leader;
  at(values, Series::UnlikelyMove) = cost.move;
  at(values, Series::NotMeant) = cost.meant;
  at(values, Series::ChangeOfSource) = cost.change + cost.temporal;
  at(values, Series::IntentTotal) = cost.total;
}

/// Additional cost of the cheapest other candidate; NaN without one.
/// @param total  of a candidate; NaN where it has none
template <typename Total>
double margin(const FrameResult& result, std::size_t selected, Total total) {
  double second = none;
  for (std::size_t c = 0; c < result.candidates.size(); ++c)
    if (c != selected) second = std::fmin(second, total(result.candidates[c]));
  return second - total(result.candidates[selected]);
}

void read_costs(const FrameSnapshot& frame, SeriesValues& values) {
  const FrameResult& result = frame.result;
  if (result.selected < 0 || static_cast<std::size_t>(result.selected) >= result.candidates.size()) return;
  const auto selected = static_cast<std::size_t>(result.selected);
  const Candidate& winner = result.candidates[selected];
  at(values, Series::PoseCost) = winner.cost.pose;
  at(values, Series::LeaderCost) = frame.settings.alpha * winner.cost.temporal_active;
  at(values, Series::FollowerCost) = frame.settings.alpha * winner.cost.temporal_passive;
  at(values, Series::TotalCost) = winner.cost.total;
  at(values, Series::CostMargin) = margin(result, selected, [](const Candidate& c) { return c.cost.total; });
  if (!winner.intent) return;
  read_intent_cost(*winner.intent, values);
  at(values, Series::IntentMargin) =
      margin(result, selected, [](const Candidate& c) { return c.intent ? c.intent->total : none; });
}

bool partner_is_active(const FrameSnapshot& frame) {
  return frame.settings.user_role == UserRole::Passive;
}

/// Rest height of the partner's feet; of an average adult without a library.
ToeRest rest_of_partner(const FrameSnapshot& frame) {
  if (!frame.library) return toe_rest(Body{});
  const MotionLibrary& library = *frame.library;
  return toe_rest(
      (partner_is_active(frame) ? library.usual_active_body() : library.usual_passive_body()).body);
}

/// The recorded partner from the pair before the selected one to the pair after it.
std::optional<MovementStep> recorded_step(const FrameSnapshot& frame) {
  const FrameResult& result = frame.result;
  if (!frame.library || result.selected < 0) return std::nullopt;
  const MotionLibrary& library = *frame.library;
  const int pair = result.candidates[static_cast<std::size_t>(result.selected)].pair;
  if (pair < 0 || pair >= library.pair_count()) return std::nullopt;
  MovementSteps steps(rest_of_partner(frame));
  std::optional<MovementStep> step;
  for (const int advance : {-1, 0, 1}) {
    const int there = library.later_pair(pair, advance);
    if (there < 0) continue;
    const RootFrame& root = library.root(there);
    const Pose normalised =
        library.pose(there).middleRows<joint_count>(partner_is_active(frame) ? 0 : joint_count);
    const Pose world = (normalised * root.rotation().transpose()).rowwise() + root.position.transpose();
    step = steps.next(world, library.source(there).frame / library.take_of(there).fps);
  }
  return step;
}

}  // namespace

const std::array<SeriesInfo, series_count>& all_series() {
  using enum Series;
  static const std::array<SeriesInfo, series_count> infos = {{
      {DeformationEnergy, "energy.deformation", "Energy", "deformation E_L", "E_L", "m²", 3,
       "how far the mesh is bent from the selected pair's"},
      {VelocityEnergy, "energy.velocity", "Energy", "velocity w_Δ E_V", "w_Δ E_V", "m²", 3,
       "how far the pair moved since the previous step, times its weight at this rate"},
      {ConstraintEnergy, "energy.constraint", "Energy", "constraint E_C", "E_C", "m²", 3,
       "how far the leader is from the user's pose, times w_C"},
      {FootLock, "residual.foot_lock", "Residuals", "foot lock", "foot lock", "mm", 2,
       "largest drift of a locked foot"},
      {ExcessPenetration, "residual.excess_penetration", "Residuals", "excess penetration", "excess pen.",
       "mm", 1, "deepest overlap beyond the selected pair's own"},
      {Penetration, "residual.penetration", "Residuals", "penetration", "penetration", "mm", 1,
       "deepest overlap of two limbs"},
      {MorphRms, "residual.morph_rms", "Residuals", "leader from user, rms", "from user", "mm", 1,
       "joints of the leader from the user's pose"},
      {BoneLength, "residual.bone_length", "Bone length", "bone length error", "bones", "%", 3,
       "largest change of a bone's length"},
      {PoseCost, "cost.pose", "Cost", "pose", "pose", "m²", 3, "of the winner, Eq. 7"},
      {LeaderCost, "cost.leader", "Cost", "temporal leader", "leader", "m²", 3, "of the winner, times α"},
      {FollowerCost, "cost.follower", "Cost", "temporal follower", "follower", "m²", 3,
       "of the winner, times α"},
      {TotalCost, "cost.total", "Cost", "total cost", "total", "m²", 3, "of the winner, Eq. 7"},
      {CostMargin, "cost.margin", "Cost", "margin to the runner-up", "margin", "m²", 3,
       "how much more the cheapest of the others costs; below 0 if that one was cheaper"},
      {ExpectedPartner, "intent.partner", "Cost by intent", "expected partner distance", "partner", "m", 3,
       "of the winner: expected mean joint distance of its partner from the one that fits the user's intent"},
      {LeaderMotion, "intent.leader", "Cost by intent", "motion of the leader", "leader", "m", 3,
       "of the winner: w_l (1 − k), k compares the user's last 2 s with those before the pair"},
      {UnlikelyMove, "intent.move", "Cost by intent", "unlikely move", "move", "m", 3,
       "of the winner: w_m (1 − P(its label))"},
      {NotMeant, "intent.meant", "Cost by intent", "not the intended move", "intended", "m", 3,
       "of the winner: w_p if another move is intended"},
      {ChangeOfSource, "intent.change", "Cost by intent", "change of source", "change", "m", 3,
       "of the winner: the margin if it does not continue the source, and α times its distance from the "
       "shown partner"},
      {IntentTotal, "intent.total", "Cost by intent", "total by intent", "total", "m", 3,
       "of the winner: the total that intent minimises"},
      {IntentMargin, "intent.margin", "Cost by intent", "margin by intent to the runner-up", "margin", "m", 3,
       "how much more the cheapest of the others costs; below 0 if that one was cheaper"},
      {RetargetTime, "time.retarget", "Step time", "retarget", "retarget", "ms", 3, "user onto the body"},
      {SelectTime, "time.select", "Step time", "select", "select", "ms", 3, "neighbours and their costs"},
      {MeshTime, "time.mesh", "Step time", "mesh", "mesh", "ms", 3, "reference of the deformation"},
      {SolveTime, "time.solve", "Step time", "solve", "solve", "ms", 3, "morph and projection steps"},
      {TotalTime, "time.total", "Step time", "whole step", "total", "ms", 3, "from pose in to partner out"},
      {HoldChange, "metric.hold_change", "Metrics", "hold change", "holds", "mm", 1,
       "distance of hands that hold one another, result against selected pair; none without a hold"},
      {PartnerStep, "metric.partner_step", "Metrics", "partner's step", "step", "mm", 1,
       "displacement of a joint of the partner since the previous step, mean"},
      {BehindSelected, "metric.behind_selected", "Metrics", "partner behind selected pair", "behind", "mm", 1,
       "distance of a joint of the partner from the selected pair's, mean"},
      {SourceChanges, "metric.source_changes", "Source changes", "source changes per 100 steps", "changes",
       "per 100", 0, "over the last 100 steps"},
      {PartnerSpeed, "movement.speed", "Speed of the partner", "speed of the partner", "partner", "m/s", 2,
       "mean over the joints"},
      {RecordedSpeed, "movement.recorded_speed", "Speed of the partner", "speed of the recorded partner",
       "recorded", "m/s", 2, "in its take, where the selected pair is"},
      {FootSlide, "movement.slide", "Speed of the partner", "sliding of the partner's landed feet", "slide",
       "m/s", 2, "the faster toe base of those less than 3 cm above their rest; none without a landed foot"},
      {PartnerAcceleration, "movement.acceleration", "Acceleration of the partner",
       "acceleration of the partner", "partner", "m/s²", 1, "of the joints, root mean square"},
      {RecordedAcceleration, "movement.recorded_acceleration", "Acceleration of the partner",
       "acceleration of the recorded partner", "recorded", "m/s²", 1,
       "in its take, where the selected pair is"},
      {JointResidual, "selected.joint_residual", "Selected joint", "residual of the selected joint",
       "residual", "mm", 1,
       "|δ − L(v′)| of the joint that was selected last: how far its neighbourhood is bent"},
      {JointFromUser, "selected.joint_from_user", "Selected joint", "selected joint from the user's",
       "from user", "mm", 1, "only of the user's character"},
      {JointFromSelected, "selected.joint_from_pair", "Selected joint",
       "selected joint from the selected pair's", "from pair", "mm", 1,
       "distance to the same joint of the selected pair"},
      {JointSpeed, "selected.joint_speed", "Speed of the selected joint", "speed of the selected joint",
       "speed", "m/s", 2, "since the previous frame"},
      {EdgeLength, "selected.edge_length", "Selected edge", "length of the selected edge", "length", "mm", 0,
       "in the result"},
      {EdgeReference, "selected.edge_reference", "Selected edge", "its length in the selected pair",
       "in pair", "mm", 0, "what the length was before the edit"},
      {EdgeResidual, "selected.edge_residual", "Selected edge", "residual of the selected edge", "residual",
       "mm", 1, "mean of its ends"},
      {EdgeWeight, "selected.edge_weight", "Weight of the selected edge", "weight of the selected edge",
       "weight", "1", 3, "mean weight in the Laplacian coordinates of its ends"},
      {CellRatio, "selected.cell_ratio", "Selected tetrahedron", "volume ratio of the selected tetrahedron",
       "ratio", "1", 2, "volume in the result over that in the selected pair; below 0 inverted"},
  }};
  return infos;
}

const SeriesInfo& info_of(Series series) {
  return all_series()[static_cast<std::size_t>(series)];
}

std::optional<Series> find_series(std::string_view key) {
  const auto found = std::ranges::find(all_series(), key, &SeriesInfo::key);
  return found == all_series().end() ? std::nullopt : std::optional(found->series);
}

SeriesValues SeriesReader::read(const FrameSnapshot& frame) {
  SeriesValues values;
  values.fill(none);
  read_timings(frame.result.timing, values);
  if (previous_ && frame.index != previous_->index + 1) {
    previous_.reset();
    moving_.reset();
  }
  if (previous_) solver_s_ += frame.elapsed_s > 0 ? frame.elapsed_s : frame.time_s - previous_->time_s;
  const bool failed = frame.result.status == StepStatus::Failed;
  if (!failed) {
    read_energies(frame, values);
    read_residuals(frame.result.residual, values);
    read_costs(frame, values);
    read_metrics(frame, values);
    read_movement(frame, values);
  } else {
    moving_.reset();
  }
  remember(frame, failed);
  return values;
}

void SeriesReader::remember(const FrameSnapshot& frame, bool failed) {
  if (!previous_) previous_ = Previous{0, 0, none, std::nullopt};
  previous_->index = frame.index;
  previous_->time_s = frame.time_s;
  if (failed) return previous_->partner.reset();
  previous_->solved_s = solver_s_;
  previous_->partner = frame.result.passive();
}

void SeriesReader::read_energies(const FrameSnapshot& frame, SeriesValues& values) const {
  const FrameEnergy& energy = frame.result.energy;
  at(values, Series::DeformationEnergy) = energy.deformation;
  at(values, Series::ConstraintEnergy) = energy.constraint;
  // The weight depends on the time since the last step that was solved.
  if (energy.velocity == 0)
    at(values, Series::VelocityEnergy) = 0;
  else if (previous_ && std::isfinite(previous_->solved_s))
    at(values, Series::VelocityEnergy) =
        velocity_weight_at(frame.settings, solver_s_ - previous_->solved_s) * energy.velocity;
}

void SeriesReader::read_metrics(const FrameSnapshot& frame, SeriesValues& values) {
  const FrameResult& result = frame.result;
  at(values, Series::HoldChange) = mm_per_m * hold_change_m(result.result, result.selected_pair);
  at(values, Series::BehindSelected) =
      mm_per_m * mean_joint_distance(result.passive(), result.selected_pair.bottomRows<joint_count>());
  if (previous_ && previous_->partner)
    at(values, Series::PartnerStep) = mm_per_m * mean_joint_distance(result.passive(), *previous_->partner);
  changes_.push_back(result.source_changed);
  if (changes_.size() > source_window_steps) changes_.pop_front();
  at(values, Series::SourceChanges) =
      100.0 * static_cast<double>(std::ranges::count(changes_, true)) / static_cast<double>(changes_.size());
}

void SeriesReader::read_movement(const FrameSnapshot& frame, SeriesValues& values) {
  const UserRole role = frame.settings.user_role;
  if (!moving_ || moving_->library != frame.library || moving_->user_role != role)
    moving_.emplace(Moving{frame.library, role, MovementSteps(rest_of_partner(frame))});
  const Pose partner =
      frame.result.result.middleRows<joint_count>(partner_is_active(frame) ? 0 : joint_count);
  if (const auto step = moving_->steps.next(partner, solver_s_)) {
    at(values, Series::PartnerSpeed) = step->speed_m_s;
    at(values, Series::PartnerAcceleration) = step->acceleration_m_s2.value_or(none);
    at(values, Series::FootSlide) =
        std::fmax(step->slide_m_s[0].value_or(none), step->slide_m_s[1].value_or(none));
  }
  if (const auto recorded = recorded_step(frame)) {
    at(values, Series::RecordedSpeed) = recorded->speed_m_s;
    at(values, Series::RecordedAcceleration) = recorded->acceleration_m_s2.value_or(none);
  }
}

}  // namespace abrazo::widgets
