#include "core/metrics/run_summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/json_text.hpp"
#include "core/base/printable.hpp"
#include "core/base/statistics.hpp"
#include "core/metrics/partner_error.hpp"

namespace abrazo {

void RunSummary::add(const FrameResult& frame) {
  ++frames_;
  total_us_.push_back(frame.timing.total_us);
  if (frame.status == StepStatus::Failed) {
    ++failed_;
    continuity_.interrupt();
    return;
  }
  if (frame.status == StepStatus::Relaxed) ++relaxed_;
  bone_length_max_ = std::max(bone_length_max_, frame.residual.bone_length_max);
  foot_lock_drift_max_m_ = std::max(foot_lock_drift_max_m_, frame.residual.foot_lock_max_m);
  morph_rms_m_.push_back(frame.residual.morph_rms_m);
  const Pose partner = frame.result.middleRows<joint_count>(partner_row_);
  behind_m_.push_back(
      mean_joint_distance(partner, frame.selected_pair.middleRows<joint_count>(partner_row_)));
  continuity_.add(partner, frame.source_changed);
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
  json.end_object();
  return json.take();
}

}  // namespace abrazo
