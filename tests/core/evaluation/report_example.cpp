#include "tests/core/evaluation/report_example.hpp"

namespace abrazo::test {

namespace {

SelectionTable selection_table(double rate_hz, int pairs, double missed) {
  SelectionTable table{.rate_hz = rate_hz, .pairs = pairs, .queries = 1000, .rows = {}};
  for (int k = 5; k <= 50; k += 5)
    table.rows.push_back({.k = k,
                          .recall_best = 1 - missed * 10 / k,
                          .recall_best2 = 1 - missed * 7 / k,
                          .pose_excess = 0.12 / k,
                          .query_us = 40.0 + k});
  return table;
}

MoveTable move_table(int successful) {
  MoveTable moves;
  moves.all = {.total = 20, .successful = successful, .lenient = successful + 2};
  moves.per_take = {{"salsa_01", {.total = 8, .successful = successful / 2, .lenient = 8}},
                    {"salsa_02", {.total = 12, .successful = successful - successful / 2, .lenient = 11}}};
  moves.per_label = {{"closed_hold", {.total = 5, .successful = 2, .lenient = 3}},
                     {"cross_body_lead", {.total = 7, .successful = successful - 8, .lenient = 7}},
                     {"turn", {.total = 8, .successful = 6, .lenient = 7}}};
  moves.labels = {"closed_hold", "cross_body_lead", "turn", "other"};
  moves.confusion = {{2, 2, 0, 1}, {0, successful - 8, 15 - successful, 0}, {1, 1, 6, 0}, {0, 0, 0, 0}};
  moves.steps = {{31, 20, 4, 9}, {3, 90, 12, 1}, {14, 11, 82, 2}, {0, 0, 0, 0}};
  moves.step_accuracy = 203.0 / 279;
  moves.by_chance = 0.4;
  return moves;
}

ContinuityMetric::Figures continuity(double scale) {
  return {.displacement_mean_m = 0.047 * scale,
          .displacement_p95_m = 0.091 * scale,
          .displacement_p99_m = 0.11 * scale,
          .displacement_max_m = 0.121 * scale,
          .second_difference_mean_m = 0.02 * scale,
          .second_difference_p99_m = 0.06 * scale,
          .source_changes_per_100 = 16 * scale,
          .steps = 900};
}

Percentiles percentiles_up_to(double largest) {
  Percentiles percentiles;
  for (int percent = 0; percent <= 100; ++percent) percentiles.push_back(largest * percent / 100);
  return percentiles;
}

MovementTable movement_table() {
  MovementTable movement;
  MovementFigures& f = movement.all;
  f.partner_error_m = 0.36, f.selected_error_m = 0.35;
  f.speed_p50_m_s = 0.9, f.captured_speed_p50_m_s = 0.68;
  f.speed_p99_m_s = 4.46, f.captured_speed_p99_m_s = 1.57;
  f.speed_rms_m_s = 1.3, f.captured_speed_rms_m_s = 0.8;
  f.acceleration_rms_m_s2 = 84, f.captured_acceleration_rms_m_s2 = 11.6, f.acceleration_ratio = 7.29;
  f.slide_m_s = 0.79, f.captured_slide_m_s = 0.147;
  f.slide_share_fast = 0.52, f.captured_slide_share_fast = 0.095;
  f.hover_mean_m = 0.031, f.hover_p90_m = 0.072;
  f.hold_change_m = 0.0425, f.captured_holds_held = 0.767, f.captured_hold_distance_m = 0.15;
  f.captured_hold_recall = 0.61, f.captured_hold_precision = 0.9;
  f.changes_per_s = 2.05, f.step_at_change_max_m = 0.29;
  f.pace_p05 = 0, f.pace_p50 = 1, f.pace_p95 = 3, f.standing_share = 0.5, f.source_pace_share = 0.385;
  movement.takes = {"salsa_01", "salsa_02"};
  movement.per_take = {f, f};
  movement.captured = {percentiles_up_to(1.8), percentiles_up_to(30), percentiles_up_to(0.5)};
  movement.made = {percentiles_up_to(6), percentiles_up_to(300), percentiles_up_to(3)};
  movement.pace = percentiles_up_to(3);
  movement.hover_m = percentiles_up_to(0.18);
  return movement;
}

UserResult user_result(const std::string& name, int successful, double error_m) {
  UserResult result;
  result.user = name;
  result.moves = move_table(successful);
  result.zmp = {.original_m = 0.0374,
                .synthesised_m = 0.0385,
                .original_partner_m = 0.035,
                .synthesised_partner_m = 0.0368,
                .frames = 1700,
                .skipped_frames = 64,
                .original_skipped_frames = 61,
                .partner_between_changes_m = 0.0354,
                .original_between_changes_m = 0.0352,
                .between_changes_share = 0.64,
                .common = {.first_m = 0.037, .second_m = 0.039, .frames = 1650},
                .common_partner = {.first_m = 0.035, .second_m = 0.04, .frames = 820},
                .partner_free_fall = 30,
                .original_partner_free_fall = 1,
                .partner_no_support = 20,
                .original_partner_no_support = 2,
                .partner_frames = 850,
                .original_partner_frames = 870,
                .settings = {}};
  result.contact.holds.holds = 431;
  result.contact.holds.shown_holds = 428;
  result.contact.holds.change_mean_m = 0.0131;
  result.contact.holds.change_p95_m = 0.041;
  result.contact.holds.kept = 0.93;
  result.contact.holds.precision = 0.95;
  result.contact.holds.f1 = 0.94;
  result.contact.penetration = {.deep_share = 0.08,
                                .mean_m = 0.002,
                                .p99_m = 0.021,
                                .max_m = 0.05,
                                .excess_p99_m = 0.004,
                                .excess_max_m = 0.019,
                                .frames = 900};
  result.contact.original_penetration = {.deep_share = 0.07, .mean_m = 0.0019, .p99_m = 0.019, .max_m = 0.04};
  result.contact.original_foot_slide_m_s = 0.155;
  result.contact.foot_slide_m_s = 0.048;
  result.contact.user_foot_slide_m_s = 0.061;
  result.contact.bone_length_max = 0.00021;
  result.contact.foot_lock_drift_max_m = 0.0000042;
  result.partner = {.mean_joint_error_m = error_m,
                    .median_joint_error_m = 0.29,
                    .p95_joint_error_m = 0.83,
                    .lag_s = 0.133,
                    .lag_correlation = 0.43,
                    .behind_selected_mean_m = 0.17,
                    .continuity = continuity(2),
                    .original_continuity = continuity(1)};
  result.movement = movement_table();
  result.solve = {.p50_us = 431.5, .p95_us = 602, .p99_us = 755.25, .steps = 900, .relaxed = 12, .failed = 1};
  return result;
}

PublishedTable published_table() {
  PublishedTable table;
  table.clips = 44;
  double value = 0.01;
  for (PublishedFigures* figures : {&table.made, &table.nearest, &table.captured})
    for (const PublishedRow& row : published_rows()) figures->*row.figure = value += 0.01;
  return table;
}

}  // namespace

Evaluation example_evaluation() {
  Evaluation evaluation;
  evaluation.data = "cmu-salsa";
  evaluation.settings = *preset("paper");
  evaluation.settings.neighbours = 25;
  evaluation.step_rate_hz = 15;
  evaluation.library_pairs = 28672;
  evaluation.takes = {"salsa_01", "salsa_02"};
  evaluation.seconds = 412;
  evaluation.selection = {selection_table(60, 26000, 0.17), selection_table(15, 6500, 0.051)};
  evaluation.timing = {{.pairs = 7500, .generated = 0, .knn_us = 29, .brute_us = 1800},
                       {.pairs = 15000, .generated = 0, .knn_us = 41, .brute_us = 3700},
                       {.pairs = 30000, .generated = 4000, .knn_us = 62, .brute_us = 7600},
                       {.pairs = 1000000, .generated = 974000, .knn_us = 610, .brute_us = 255000}};
  evaluation.result = user_result("as captured", 14, 0.361);
  evaluation.result->published = published_table();
  evaluation.builds = {user_result("user at 85 %", 13, 0.39), user_result("arms 20 % longer", 12, 0.37)};
  evaluation.disturbed = {user_result("20 % of frames lost", 12, 0.377), user_result("noise 2 cm", 11, 0.402),
                          user_result("delay 200 ms", 13, 0.47)};
  evaluation.has_moves = evaluation.has_zmp = evaluation.has_contact = true;
  evaluation.remarks = {"take salsa_09 has no labelled moves and does not count in them"};
  return evaluation;
}

}  // namespace abrazo::test
