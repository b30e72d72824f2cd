#include "core/evaluation/tables/movement_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/statistics.hpp"
#include "core/evaluation/takes/take_synthesis.hpp"
#include "core/metrics/holds.hpp"
#include "core/metrics/motion_quality.hpp"
#include "core/metrics/partner_error.hpp"

namespace abrazo {

namespace {

using TakeFigures = MovementFigures;

constexpr std::array movement_row_table = {
    MovementRow{"partner_error_m", "joint error, mean", "cm", FigureGoal::Lowest, 100,
                &TakeFigures::partner_error_m},
    MovementRow{"selected_error_m", "joint error of the selected pair's partner, mean", "cm",
                FigureGoal::Lowest, 100, &TakeFigures::selected_error_m},
    MovementRow{"lag_s", "lag", "ms", FigureGoal::NearestZero, 1000, &TakeFigures::lag_s},
    MovementRow{"speed_p50_m_per_s", "speed, median", "m/s", FigureGoal::Lowest, 1,
                &TakeFigures::speed_p50_m_s, &TakeFigures::captured_speed_p50_m_s},
    MovementRow{"speed_p99_m_per_s", "speed, 99th percentile", "m/s", FigureGoal::Lowest, 1,
                &TakeFigures::speed_p99_m_s, &TakeFigures::captured_speed_p99_m_s},
    MovementRow{"speed_rms_m_per_s", "speed, root mean square", "m/s", FigureGoal::Lowest, 1,
                &TakeFigures::speed_rms_m_s, &TakeFigures::captured_speed_rms_m_s},
    MovementRow{"acceleration_p50", "acceleration, median", "m/s\u00b2", FigureGoal::Lowest, 1,
                &TakeFigures::acceleration_p50_m_s2, &TakeFigures::captured_acceleration_p50_m_s2},
    MovementRow{"acceleration_p99", "acceleration, 99th percentile", "m/s\u00b2", FigureGoal::Lowest, 1,
                &TakeFigures::acceleration_p99_m_s2, &TakeFigures::captured_acceleration_p99_m_s2},
    MovementRow{"acceleration_rms", "acceleration, root mean square", "m/s\u00b2", FigureGoal::Lowest, 1,
                &TakeFigures::acceleration_rms_m_s2, &TakeFigures::captured_acceleration_rms_m_s2},
    MovementRow{"acceleration_ratio", "acceleration, times the captured", "", FigureGoal::Lowest, 1,
                &TakeFigures::acceleration_ratio},
    MovementRow{"step_max_m", "largest step", "cm", FigureGoal::Lowest, 100, &TakeFigures::largest_step_m,
                &TakeFigures::captured_largest_step_m, true},
    MovementRow{"slide_m_per_s", "sliding of landed feet, mean", "m/s", FigureGoal::Lowest, 1,
                &TakeFigures::slide_m_s, &TakeFigures::captured_slide_m_s},
    MovementRow{"slide_share_fast", "sliding of landed feet, share faster than 0.3 m/s", "%",
                FigureGoal::Lowest, 100, &TakeFigures::slide_share_fast,
                &TakeFigures::captured_slide_share_fast},
    MovementRow{"landed_share", "share of the feet's steps that are landed", "%", FigureGoal::Lowest, 100,
                &TakeFigures::landed_share, &TakeFigures::captured_landed_share},
    MovementRow{"hover_mean_m", "height of locked toe bases above their rest, mean", "mm", FigureGoal::Lowest,
                1000, &TakeFigures::hover_mean_m},
    MovementRow{"hover_p90_m", "height of locked toe bases above their rest, 90th percentile", "mm",
                FigureGoal::Lowest, 1000, &TakeFigures::hover_p90_m},
    MovementRow{"hold_change_mean_m", "holds of the selected pair: change of distance, mean", "mm",
                FigureGoal::Lowest, 1000, &TakeFigures::hold_change_m},
    MovementRow{"captured_holds_held", "holds of the capture: held (within 20 cm)", "%", FigureGoal::Highest,
                100, &TakeFigures::captured_holds_held},
    MovementRow{"captured_hold_recall", "holds of the capture: recall (within 13 cm)", "%",
                FigureGoal::Highest, 100, &TakeFigures::captured_hold_recall},
    MovementRow{"captured_hold_precision", "holds of the result: precision (within 20 cm in the capture)",
                "%", FigureGoal::Highest, 100, &TakeFigures::captured_hold_precision},
    MovementRow{"captured_hold_distance_mean_m", "holds of the capture: distance of the hands, mean", "cm",
                FigureGoal::Lowest, 100, &TakeFigures::captured_hold_distance_m},
    MovementRow{"changes_per_s", "changes of source", "1/s", FigureGoal::Lowest, 1,
                &TakeFigures::changes_per_s},
    MovementRow{"step_at_change_mean_m", "step at a change, beyond what its own velocity explains, mean",
                "cm", FigureGoal::Lowest, 100, &TakeFigures::step_at_change_mean_m},
    MovementRow{"step_at_change_max_m", "step at a change, beyond what its own velocity explains, largest",
                "cm", FigureGoal::Lowest, 100, &TakeFigures::step_at_change_max_m, nullptr, true},
    MovementRow{"pace.p05", "pace of the source, 5th percentile", "", FigureGoal::None, 1,
                &TakeFigures::pace_p05},
    MovementRow{"pace.p50", "pace of the source, median", "", FigureGoal::None, 1, &TakeFigures::pace_p50},
    MovementRow{"pace.p95", "pace of the source, 95th percentile", "", FigureGoal::None, 1,
                &TakeFigures::pace_p95},
    MovementRow{"pace.standing_share", "steps in which the source stands (pace below 0.25)", "%",
                FigureGoal::Lowest, 100, &TakeFigures::standing_share},
    MovementRow{"pace.own_share", "steps at the source's own pace (0.75 to 1.25)", "%", FigureGoal::Highest,
                100, &TakeFigures::source_pace_share},
};

/// What all takes have together, for the curves.
struct Pooled {
  struct Moved {
    std::vector<double> speed_m_s, acceleration_m_s2, slide_m_s;
    void add(const MovementMetric& metric) {
      const auto append = [](std::vector<double>& to, const std::vector<double>& from) {
        to.insert(to.end(), from.begin(), from.end());
      };
      append(speed_m_s, metric.speeds_m_s());
      append(acceleration_m_s2, metric.accelerations_m_s2());
      append(slide_m_s, metric.slide().speeds_m_s());
    }
  };
  Moved made, captured;
  std::vector<double> pace, hover_m;
};

void set_quality(const MotionQuality::Figures& quality, MovementFigures& f) {
  const MovementMetric::Figures& moved = quality.movement;
  f.speed_p50_m_s = moved.speed_p50_m_s;
  f.speed_p99_m_s = moved.speed_p99_m_s;
  f.speed_rms_m_s = moved.speed_rms_m_s;
  f.acceleration_p50_m_s2 = moved.acceleration_p50_m_s2;
  f.acceleration_p99_m_s2 = moved.acceleration_p99_m_s2;
  f.acceleration_rms_m_s2 = moved.acceleration_rms_m_s2;
  f.largest_step_m = moved.largest_step_m;
  f.slide_m_s = moved.slide.mean_m_s;
  f.slide_share_fast = moved.slide.share_fast;
  f.landed_share = moved.slide.landed_share;
  f.hover_mean_m = quality.hover_mean_m;
  f.hover_p90_m = quality.hover_p90_m;
  f.changes_per_s = quality.changes_per_s;
  f.step_at_change_max_m = quality.step_at_change_max_m;
  f.step_at_change_mean_m = quality.step_at_change_mean_m;
  f.pace_p05 = quality.pace_p05;
  f.pace_p50 = quality.pace_p50;
  f.pace_p95 = quality.pace_p95;
  f.standing_share = quality.standing_share;
  f.source_pace_share = quality.source_pace_share;
}

void set_captured(const MovementMetric::Figures& captured, MovementFigures& f) {
  f.captured_speed_p50_m_s = captured.speed_p50_m_s;
  f.captured_speed_p99_m_s = captured.speed_p99_m_s;
  f.captured_speed_rms_m_s = captured.speed_rms_m_s;
  f.captured_acceleration_p50_m_s2 = captured.acceleration_p50_m_s2;
  f.captured_acceleration_p99_m_s2 = captured.acceleration_p99_m_s2;
  f.captured_acceleration_rms_m_s2 = captured.acceleration_rms_m_s2;
  f.acceleration_ratio = f.acceleration_rms_m_s2 / captured.acceleration_rms_m_s2;
  f.captured_largest_step_m = captured.largest_step_m;
  f.captured_slide_m_s = captured.slide.mean_m_s;
  f.captured_slide_share_fast = captured.slide.share_fast;
  f.captured_landed_share = captured.slide.landed_share;
}

void set_holds(const HoldMetric::Figures& of_pairs, const HoldMetric::Figures& of_capture,
               MovementFigures& f) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  f.hold_change_m = of_pairs.holds > 0 ? of_pairs.change_mean_m : nothing;
  f.captured_holds_held = of_capture.holds > 0 ? of_capture.kept : nothing;
  f.captured_hold_recall = of_capture.holds > 0 ? of_capture.recall : nothing;
  f.captured_hold_distance_m = of_capture.holds > 0 ? of_capture.distance_mean_m : nothing;
  f.captured_hold_precision = of_capture.shown_holds > 0 ? of_capture.precision : nothing;
}

MovementFigures measure_take_movement(const SynthesisedTake& take, Pooled& pooled) {
  const ToeRest rest = toe_rest(take.true_partner_clip().poses);
  MotionQuality quality(rest);
  MovementMetric captured(rest);
  HoldMetric of_pairs, of_capture(HoldMetric::captured_hold_held_m);
  std::vector<double> errors_m, selected_errors_m;
  std::vector<Pose> made_poses, captured_poses;
  for (std::size_t step = 0; step < take.size(); ++step) {
    if (!take.follows[step]) quality.interrupt(), captured.interrupt();
    const PartnerStep made = take.partner_step(step);
    quality.add(made);
    captured.add(take.true_partner(step), made.time_s);
    of_pairs.add(take.results[step], take.selected[step]);
    of_capture.add(take.results[step], take.true_pair(step));
    made_poses.push_back(made.partner);
    captured_poses.push_back(take.true_partner(step));
    errors_m.push_back(mean_joint_distance(made.partner, take.true_partner(step)));
    selected_errors_m.push_back(mean_joint_distance(take.selected_partner(step), take.true_partner(step)));
  }
  pooled.made.add(quality.movement());
  pooled.captured.add(captured);
  pooled.pace.insert(pooled.pace.end(), quality.paces().begin(), quality.paces().end());
  pooled.hover_m.insert(pooled.hover_m.end(), quality.hovers_m().begin(), quality.hovers_m().end());
  MovementFigures figures;
  figures.lag_s = measure_lag(captured_poses, made_poses, take.rate_hz).shift_s;
  figures.partner_error_m = mean(errors_m);
  figures.selected_error_m = mean(selected_errors_m);
  set_quality(quality.figures(), figures);
  set_captured(captured.figures(), figures);
  set_holds(of_pairs.figures(), of_capture.figures(), figures);
  return figures;
}

/// Over those takes in which there was something to measure.
double over_takes(std::span<const MovementFigures> takes, double MovementFigures::*figure, bool largest) {
  std::vector<double> values;
  for (const MovementFigures& take : takes)
    if (!std::isnan(take.*figure)) values.push_back(take.*figure);
  return values.empty() || largest ? quantile(values, 1) : mean(values);
}

Percentiles percentiles_of(std::vector<double> values) {
  Percentiles percentiles;
  if (values.empty()) return percentiles;
  std::sort(values.begin(), values.end());
  for (int percent = 0; percent <= 100; ++percent) percentiles.push_back(quantile(values, percent / 100.0));
  return percentiles;
}

MovementTable::Curves curves_of(Pooled::Moved moved) {
  return {.speed_m_s = percentiles_of(std::move(moved.speed_m_s)),
          .acceleration_m_s2 = percentiles_of(std::move(moved.acceleration_m_s2)),
          .slide_m_s = percentiles_of(std::move(moved.slide_m_s))};
}

}  // namespace

std::span<const MovementRow> movement_rows() {
  return movement_row_table;
}

MovementTable measure_movement(std::span<const SynthesisedTake> takes) {
  MovementTable table;
  Pooled pooled;
  for (const SynthesisedTake& take : takes) {
    table.takes.push_back(take.take->name);
    table.per_take.push_back(measure_take_movement(take, pooled));
  }
  for (const MovementRow& row : movement_rows()) {
    table.all.*row.made = over_takes(table.per_take, row.made, row.largest);
    if (row.captured) table.all.*row.captured = over_takes(table.per_take, row.captured, row.largest);
  }
  table.made = curves_of(std::move(pooled.made));
  table.captured = curves_of(std::move(pooled.captured));
  table.pace = percentiles_of(std::move(pooled.pace));
  table.hover_m = percentiles_of(std::move(pooled.hover_m));
  return table;
}

}  // namespace abrazo
