#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/evaluation/tables/figure_goal.hpp"

namespace abrazo {

struct SynthesisedTake;

/// Motion of the partner in one take, or on average: of the synthesised partner, and of the captured one
/// (`captured_`) at the same steps. NaN if there was nothing to measure.
struct MovementFigures {
  double partner_error_m = 0, selected_error_m = 0;
  double lag_s = 0;  ///< positive: late
  double speed_p50_m_s = 0, captured_speed_p50_m_s = 0;
  double speed_p99_m_s = 0, captured_speed_p99_m_s = 0;
  double speed_rms_m_s = 0, captured_speed_rms_m_s = 0;
  double acceleration_p50_m_s2 = 0, captured_acceleration_p50_m_s2 = 0;
  double acceleration_p99_m_s2 = 0, captured_acceleration_p99_m_s2 = 0;
  double acceleration_rms_m_s2 = 0, captured_acceleration_rms_m_s2 = 0;
  double acceleration_ratio = 0;  ///< rms, synthesised divided by captured
  double largest_step_m = 0, captured_largest_step_m = 0;
  double slide_m_s = 0, captured_slide_m_s = 0;
  double slide_share_fast = 0, captured_slide_share_fast = 0;
  double landed_share = 0, captured_landed_share = 0;
  double hover_mean_m = 0, hover_p90_m = 0;
  double hold_change_m = 0;  ///< of the selected pair's holds
  /// Of the holds of the capture: share within 20 cm, mean distance in the result, share within 13 cm.
  double captured_holds_held = 0, captured_hold_distance_m = 0, captured_hold_recall = 0;
  double captured_hold_precision = 0;  ///< of the result's holds: share within 20 cm in the capture
  double changes_per_s = 0, step_at_change_max_m = 0, step_at_change_mean_m = 0;
  double pace_p05 = 0, pace_p50 = 0, pace_p95 = 0, standing_share = 0, source_pace_share = 0;
};

/// How a figure is written: one row of the table in report.html, one entry under "movement" in report.json.
struct MovementRow {
  std::string_view key;    ///< in report.json; "pace.p50" is p50 in the object pace
  std::string_view title;  ///< in report.html
  std::string_view unit;
  FigureGoal goal = FigureGoal::None;
  double scale = 1;  ///< shown = scale times the value
  double MovementFigures::*made = nullptr;
  double MovementFigures::*captured = nullptr;  ///< of the captured partner; none for most
  bool largest = false;                         ///< over takes the largest counts, not the mean
};
std::span<const MovementRow> movement_rows();

/// 101 values: the percentiles of the measurements in all takes; empty without measurements.
using Percentiles = std::vector<double>;

struct MovementTable {
  MovementFigures all;  ///< mean over the takes with equal weights, or the largest
  std::vector<std::string> takes;
  std::vector<MovementFigures> per_take;
  struct Curves {
    Percentiles speed_m_s, acceleration_m_s2, slide_m_s;
  };
  Curves made, captured;
  Percentiles pace, hover_m;
};

/// Motion of the partner, in every take and over all. A toe base's rest is the 5th percentile of its height
/// in the whole captured take.
MovementTable measure_movement(std::span<const SynthesisedTake> takes);

}  // namespace abrazo
