#include "core/metrics/run_comparison.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/metrics/partner_error.hpp"
#include "core/metrics/run_summary.hpp"
#include "core/metrics/zmp.hpp"

namespace abrazo {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t fewest_steps = 3;  ///< number needed for an acceleration

constexpr std::array<RunFigureInfo, run_figure_count> run_infos = {{
    {"Behind selected pair", "mm", 1e3, 0,
     "Mean distance of the partner's joints from those of the selected pair: the effect of the velocity "
     "energy."},
    {"Hold change", "mm", 1e3, 1,
     "Hands that hold one another in the selected pair (within 13 cm): mean change of their distance in the "
     "result."},
    {"Source changes", "/100", 1, 1, "Steps of 100 whose pair does not continue the previous one."},
    {"Jumps, p99", "mm", 1e3, 0, "The partner's mean joint displacement from step to step, 99th percentile."},
    {"Speed, p99", "m/s", 1, 2, "The partner's speed, mean over the joints, 99th percentile."},
    {"Acceleration", "m/s²", 1, 1, "Acceleration of the partner's joints, root mean square."},
    {"Deformation", "m²", 1, 3, "Mean deformation energy E_L against the selected pair."},
    {"User met", "mm", 1e3, 1, "Distance of the active joints from the user's pose, root mean square."},
    {"Penetration, p99", "mm", 1e3, 1,
     "Deepest overlap of the bodies beyond the selected pair's own, 99th percentile."},
    {"Foot sliding", "mm/s", 1e3, 0,
     "Mean horizontal speed of the partner's toe bases while they are less than 3 cm above their rest."},
    {"ZMP error", "mm", 1e3, 1, "Mean distance of the partner's zero moment point from the support polygon."},
    {"Bone length, max", "%", 1e2, 4, "Largest relative error of a bone's length."},
    {"Relaxed or failed", "/100", 1, 1, "Steps of 100 in which a constraint could not be satisfied."},
    {"Step, p50", "ms", 1e3, 2, "Time of a whole step, median."},
    {"Step, p99", "ms", 1e3, 2, "Time of a whole step, 99th percentile."},
}};

constexpr std::array<RunFigureInfo, step_figure_count> step_infos = {{
    {"Partner, A to B", "mm", 1e3, 0, "Mean distance between the partner's joints of A and of B."},
    {"Behind selected pair", "mm", 1e3, 0,
     "Mean distance of the partner's joints from those of the selected pair."},
    {"Hold change", "mm", 1e3, 1, "Hands that hold one another in the selected pair: change of distance."},
    {"Deformation", "m²", 1, 3, "Deformation energy E_L against the selected pair."},
    {"Penetration", "mm", 1e3, 1, "Deepest overlap of the bodies beyond the selected pair's own."},
    {"Step time", "ms", 1e3, 2, "Time of the whole step."},
}};

int partner_row(UserRole user_role) {
  return user_role == UserRole::Active ? joint_count : 0;
}

Pose partner_of(const PairPose& pair, UserRole user_role) {
  return pair.middleRows<joint_count>(partner_row(user_role));
}

double share_of_100(std::size_t part, std::size_t whole) {
  return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : nothing;
}

/// The partner's poses without a break in them.
struct Stretch {
  std::vector<Pose> poses;
  double first_s = 0, last_s = 0;
  double rate_hz() const { return static_cast<double>(poses.size() - 1) / (last_s - first_s); }
};

std::vector<Stretch> stretches_of(std::span<const RunStep> steps, UserRole user_role) {
  std::vector<Stretch> stretches;
  bool is_broken = true;
  for (const RunStep& step : steps) {
    const bool failed = step.result->status == StepStatus::Failed;
    if (!failed && (is_broken || step.starts)) stretches.push_back({{}, step.time_s, step.time_s});
    is_broken = failed;
    if (failed) continue;
    stretches.back().poses.push_back(partner_of(step.result->result, user_role));
    stretches.back().last_s = step.time_s;
  }
  std::erase_if(stretches,
                [](const Stretch& s) { return s.poses.size() < fewest_steps || s.last_s <= s.first_s; });
  return stretches;
}

double zmp_error_m(const std::vector<Stretch>& stretches) {
  ZmpError zmp;
  for (const Stretch& stretch : stretches)
    zmp.append(measure_zmp(stretch.poses, stretch.rate_hz(), ZmpSettings{}));
  return zmp.error_m.empty() ? nothing : zmp.mean_m();
}

std::array<double, step_figure_count> values_of(const FrameResult& result, UserRole user_role) {
  std::array<double, step_figure_count> values;
  values.fill(nothing);
  const auto set = [&](StepFigure figure, double value) { values[static_cast<std::size_t>(figure)] = value; };
  set(StepFigure::StepTime, result.timing.total_us * 1e-6);
  if (result.status == StepStatus::Failed) return values;
  set(StepFigure::PartnerDistance, 0);
  set(StepFigure::BehindSelected,
      mean_joint_distance(partner_of(result.result, user_role), partner_of(result.selected_pair, user_role)));
  set(StepFigure::HoldChange, hold_change_m(result.result, result.selected_pair));
  set(StepFigure::DeformationEnergy, result.energy.deformation);
  set(StepFigure::Penetration, result.residual.excess_penetration_max_m);
  return values;
}

}  // namespace

const RunFigureInfo& info_of(RunFigure figure) {
  return run_infos[static_cast<std::size_t>(figure)];
}

const RunFigureInfo& info_of(StepFigure figure) {
  return step_infos[static_cast<std::size_t>(figure)];
}

RunFigures measure_run(std::span<const RunStep> steps, const MotionLibrary& library, UserRole user_role) {
  RunFigures values;
  values.fill(nothing);
  if (steps.empty()) return values;
  RunSummary summary(library, user_role);
  double deformation = 0;
  for (const RunStep& step : steps) {
    if (step.starts) summary.interrupt();
    summary.add(*step.result, step.time_s);
    if (step.result->status != StepStatus::Failed) deformation += step.result->energy.deformation;
  }
  const RunSummary::Figures f = summary.figures();
  const std::size_t solved = f.frames - f.failed;
  const auto set = [&](RunFigure figure, double value) { values[static_cast<std::size_t>(figure)] = value; };
  set(RunFigure::Unmet, share_of_100(f.relaxed + f.failed, f.frames));
  set(RunFigure::StepTime, f.solve_us_p50 * 1e-6);
  set(RunFigure::StepTimeTail, f.solve_us_p99 * 1e-6);
  if (solved == 0) return values;
  set(RunFigure::BehindSelected, f.behind_selected_mean_m);
  if (f.holds > 0) set(RunFigure::HoldChange, f.hold_change_mean_m);
  set(RunFigure::SourceChanges, f.source_changes_per_100);
  if (solved > 1) set(RunFigure::Jumps, f.partner_displacement_p99_m);
  set(RunFigure::DeformationEnergy, deformation / static_cast<double>(solved));
  set(RunFigure::MorphDistance, f.morph_rms_m);
  set(RunFigure::Penetration, f.excess_penetration_p99_m);
  set(RunFigure::BoneLength, f.bone_length_max);
  set(RunFigure::SpeedTail, f.motion.movement.speed_p99_m_s);
  set(RunFigure::Acceleration, f.motion.movement.acceleration_rms_m_s2);
  set(RunFigure::FootSlide, f.motion.movement.slide.mean_m_s);
  set(RunFigure::ZmpError, zmp_error_m(stretches_of(steps, user_role)));
  return values;
}

std::vector<ComparedStep> compare_steps(std::span<const RunStep> a, UserRole a_role,
                                        std::span<const RunStep> b, UserRole b_role) {
  if (a.size() != b.size()) throw std::invalid_argument("two runs are compared step by step");
  constexpr auto distance = static_cast<std::size_t>(StepFigure::PartnerDistance);
  std::vector<ComparedStep> steps;
  steps.reserve(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const FrameResult &in_a = *a[i].result, &in_b = *b[i].result;
    if (a[i].time_s != b[i].time_s) throw std::invalid_argument("two runs are compared at the same times");
    ComparedStep step{a[i].time_s, values_of(in_a, a_role), values_of(in_b, b_role)};
    const bool both = !std::isnan(step.a[distance]) && !std::isnan(step.b[distance]) && a_role == b_role;
    step.a[distance] = both ? 0 : nothing;
    step.b[distance] =
        both ? mean_joint_distance(partner_of(in_a.result, a_role), partner_of(in_b.result, b_role))
             : nothing;
    steps.push_back(step);
  }
  return steps;
}

}  // namespace abrazo
