#include "core/metrics/run_summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/json_text.hpp"
#include "core/base/printable.hpp"
#include "core/base/statistics.hpp"
#include "core/metrics/partner_error.hpp"

namespace abrazo {

namespace {

/// The same names as in report.json, of the partner that was made.
void write_motion(JsonText& json, const MotionQuality::Figures& motion) {
  const auto number = [&](std::string_view key, double value) { json.key(key).value(value); };
  const MovementMetric::Figures& moved = motion.movement;
  json.key("movement").begin_object();
  number("speed_p50_m_per_s", moved.speed_p50_m_s);
  number("speed_p99_m_per_s", moved.speed_p99_m_s);
  number("speed_rms_m_per_s", moved.speed_rms_m_s);
  number("acceleration_p50", moved.acceleration_p50_m_s2);
  number("acceleration_p99", moved.acceleration_p99_m_s2);
  number("acceleration_rms", moved.acceleration_rms_m_s2);
  number("step_max_m", moved.largest_step_m);
  number("slide_m_per_s", moved.slide.mean_m_s);
  number("slide_share_fast", moved.slide.share_fast);
  number("landed_share", moved.slide.landed_share);
  number("hover_mean_m", motion.hover_mean_m);
  number("hover_p90_m", motion.hover_p90_m);
  number("changes_per_s", motion.changes_per_s);
  number("step_at_change_mean_m", motion.step_at_change_mean_m);
  number("step_at_change_max_m", motion.step_at_change_max_m);
  json.key("pace").begin_object();
  number("p05", motion.pace_p05);
  number("p50", motion.pace_p50);
  number("p95", motion.pace_p95);
  number("standing_share", motion.standing_share);
  number("own_share", motion.source_pace_share);
  json.end_object();
  json.end_object();
}

}  // namespace

RunSummary::RunSummary(const MotionLibrary& library, UserRole user_role)
    : library_(library),
      partner_is_active_(user_role == UserRole::Passive),
      motion_(
          toe_rest((partner_is_active_ ? library.usual_active_body() : library.usual_passive_body()).body)) {}

void RunSummary::interrupt() {
  continuity_.interrupt();
  motion_.interrupt();
}

void RunSummary::add(const FrameResult& frame, double time_s) {
  ++frames_;
  total_us_.push_back(frame.timing.total_us);
  if (frame.status == StepStatus::Failed) {
    ++failed_;
    interrupt();
    return;
  }
  if (frame.status == StepStatus::Relaxed) ++relaxed_;
  bone_length_max_ = std::max(bone_length_max_, frame.residual.bone_length_max);
  foot_lock_drift_max_m_ = std::max(foot_lock_drift_max_m_, frame.residual.foot_lock_max_m);
  morph_rms_m_.push_back(frame.residual.morph_rms_m);
  const PartnerStep step = partner_step(frame, time_s, library_, partner_is_active_);
  const int partner_row = partner_is_active_ ? 0 : joint_count;
  behind_m_.push_back(
      mean_joint_distance(step.partner, frame.selected_pair.middleRows<joint_count>(partner_row)));
  continuity_.add(step.partner, frame.source_changed);
  motion_.add(step);
  penetration_.add(frame.residual.penetration_max_m, frame.residual.excess_penetration_max_m);
  holds_.add(frame.result, frame.selected_pair);
}

RunSummary::Figures RunSummary::figures() const {
  const HoldMetric::Figures holds = holds_.figures();
  const ContinuityMetric::Figures continuity = continuity_.figures();
  Figures f;
  f.frames = frames_;
  f.relaxed = relaxed_;
  f.failed = failed_;
  f.solve_us_p50 = percentile(total_us_, 0.5);
  f.solve_us_p99 = percentile(total_us_, 0.99);
  f.bone_length_max = bone_length_max_;
  f.foot_lock_drift_max_m = foot_lock_drift_max_m_;
  f.excess_penetration_p99_m = penetration_.figures().excess_p99_m;
  f.holds = static_cast<std::size_t>(holds.holds);
  f.hold_change_mean_m = holds.change_mean_m;
  f.source_changes_per_100 = continuity.source_changes_per_100;
  f.partner_displacement_mean_m = continuity.displacement_mean_m;
  f.partner_displacement_p99_m = continuity.displacement_p99_m;
  f.behind_selected_mean_m = mean(behind_m_);
  f.morph_rms_m = mean(morph_rms_m_);
  f.motion = motion_.figures();
  return f;
}

std::string RunSummary::text(double step_rate_hz) const {
  const Figures f = figures();
  std::string text;
  const auto line = [&](std::string_view what, const std::string& value) {
    text += fmt::format("{:<34}{}\n", what, value);
  };
  line("library", fmt::format("{}, {} pairs", printable_line(library_.name()), library_.pair_count()));
  line("steps",
       fmt::format("{} at {:.4g} Hz, {} relaxed, {} failed", f.frames, step_rate_hz, f.relaxed, f.failed));
  line("whole step, p50 / p99",
       fmt::format("{:.3f} / {:.3f} ms", f.solve_us_p50 / 1000, f.solve_us_p99 / 1000));
  line("bone length error, max", fmt::format("{:.4f} %", 100 * f.bone_length_max));
  line("foot lock drift, max", fmt::format("{:.4f} mm", 1000 * f.foot_lock_drift_max_m));
  line("excess penetration, p99", fmt::format("{:.1f} mm", 1000 * f.excess_penetration_p99_m));
  line("hand holds, mean distance change",
       fmt::format("{:.1f} mm over {} holds", 1000 * f.hold_change_mean_m, f.holds));
  line("changes of source per 100 steps", fmt::format("{:.1f}", f.source_changes_per_100));
  line("partner displacement, mean / p99",
       fmt::format("{:.1f} / {:.1f} cm a step", 100 * f.partner_displacement_mean_m,
                   100 * f.partner_displacement_p99_m));
  const MovementMetric::Figures& moved = f.motion.movement;
  line("partner speed, p50 / p99",
       fmt::format("{:.2f} / {:.2f} m/s", moved.speed_p50_m_s, moved.speed_p99_m_s));
  line("partner acceleration, rms", fmt::format("{:.1f} m/s2", moved.acceleration_rms_m_s2));
  line("landed feet slide, mean", fmt::format("{:.2f} m/s, {:.0f} % of the time over 0.3",
                                              moved.slide.mean_m_s, 100 * moved.slide.share_fast));
  line("locked feet above rest, p90", fmt::format("{:.1f} mm", 1000 * f.motion.hover_p90_m));
  line("source changes, pace",
       fmt::format("{:.2f} a second; {:.2f} times, {:.0f} % of steps standing", f.motion.changes_per_s,
                   f.motion.pace_p50, 100 * f.motion.standing_share));
  line("largest step at a change",
       fmt::format("{:.1f} cm beyond its own velocity", 100 * f.motion.step_at_change_max_m));
  line("partner behind selected pair", fmt::format("{:.1f} cm", 100 * f.behind_selected_mean_m));
  line("active body from the user, rms", fmt::format("{:.2f} cm", 100 * f.morph_rms_m));
  return text;
}

std::string RunSummary::json(double step_rate_hz) const {
  const Figures f = figures();
  JsonText json;
  json.begin_object();
  const auto number = [&](std::string_view key, double value) { json.key(key).value(value); };
  json.key("library").value(library_.name());
  number("pairs", library_.pair_count());
  number("steps", static_cast<double>(f.frames));
  number("step_rate_hz", step_rate_hz);
  number("relaxed", static_cast<double>(f.relaxed));
  number("failed", static_cast<double>(f.failed));
  json.key("solve_us").begin_object();
  number("p50", f.solve_us_p50);
  number("p99", f.solve_us_p99);
  json.end_object();
  number("bone_length_max", f.bone_length_max);
  number("foot_lock_drift_max_m", f.foot_lock_drift_max_m);
  number("excess_penetration_p99_m", f.excess_penetration_p99_m);
  number("holds", static_cast<double>(f.holds));
  number("hold_change_mean_m", f.hold_change_mean_m);
  number("source_changes_per_100", f.source_changes_per_100);
  number("partner_displacement_mean_m", f.partner_displacement_mean_m);
  number("partner_displacement_p99_m", f.partner_displacement_p99_m);
  number("behind_selected_mean_m", f.behind_selected_mean_m);
  number("morph_rms_m", f.morph_rms_m);
  write_motion(json, f.motion);
  json.end_object();
  return json.take();
}

}  // namespace abrazo
