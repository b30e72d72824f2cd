#include "core/evaluation/report/report_json.hpp"

#include <limits>
#include <string_view>

#include "core/base/json_text.hpp"
#include "core/base/units.hpp"
#include "core/base/version.hpp"
#include "core/metrics/zmp.hpp"

namespace abrazo {

namespace {

/// An object or array that ends where it leaves scope: nesting in the code is nesting in the file.
class Object {
 public:
  Object(JsonText& json, std::string_view key) : json_(json) { json.key(key).begin_object(); }
  explicit Object(JsonText& json) : json_(json) { json.begin_object(); }
  ~Object() { json_.end_object(); }
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;

 private:
  JsonText& json_;
};

class Array {
 public:
  Array(JsonText& json, std::string_view key) : json_(json) { json.key(key).begin_array(); }
  ~Array() { json_.end_array(); }
  Array(const Array&) = delete;
  Array& operator=(const Array&) = delete;

 private:
  JsonText& json_;
};

void write_texts(JsonText& json, std::string_view key, const std::vector<std::string>& texts) {
  const Array array(json, key);
  for (const std::string& text : texts) json.value(text);
}

void write_counts(JsonText& json, std::string_view key, const std::vector<std::vector<int>>& matrix) {
  const Array array(json, key);
  for (const std::vector<int>& row : matrix) {
    json.begin_array();
    for (const int count : row) json.value(count);
    json.end_array();
  }
}

/// Of a count of nothing there is no share.
double share(int part, int total) {
  return total > 0 ? static_cast<double>(part) / total : std::numeric_limits<double>::quiet_NaN();
}

void write_selection_rows(JsonText& json, std::string_view key, const std::vector<SelectionRow>& rows) {
  const Array array(json, key);
  for (const SelectionRow& row : rows) {
    const Object object(json);
    json.key("k").value(row.k);
    json.key("recall_best").value(row.recall_best);
    json.key("recall_best2").value(row.recall_best2);
    json.key("query_us").value(row.query_us);
    json.key("pose_excess").value(row.pose_excess);
  }
}

void write_selection(JsonText& json, const std::vector<SelectionTable>& tables) {
  if (tables.empty()) return;
  write_selection_rows(json, "selection", tables.front().rows);
  const Array array(json, "selection_tables");
  for (const SelectionTable& table : tables) {
    const Object object(json);
    json.key("rate_hz").value(table.rate_hz);
    json.key("pairs").value(table.pairs);
    json.key("queries").value(table.queries);
    write_selection_rows(json, "rows", table.rows);
  }
}

void write_timing(JsonText& json, const std::vector<TimingRow>& rows) {
  if (rows.empty()) return;
  const Array array(json, "timing");
  for (const TimingRow& row : rows) {
    const Object object(json);
    json.key("pairs").value(row.pairs);
    json.key("generated").value(row.generated);
    json.key("knn_us").value(row.knn_us);
    json.key("brute_us").value(row.brute_us);
  }
}

void write_move_count(JsonText& json, const MoveCount& count) {
  json.key("total").value(count.total);
  json.key("successful").value(count.successful);
  json.key("rate").value(share(count.successful, count.total));
  json.key("lenient").value(count.lenient);
  json.key("lenient_rate").value(share(count.lenient, count.total));
}

void write_move_counts(JsonText& json, std::string_view key, const std::map<std::string, MoveCount>& counts) {
  const Object object(json, key);
  for (const auto& [name, count] : counts) {
    const Object entry(json, name);
    write_move_count(json, count);
  }
}

void write_moves(JsonText& json, const MoveTable& moves) {
  const Object object(json, "moves");
  write_move_count(json, moves.all);
  write_move_counts(json, "per_take", moves.per_take);
  write_move_counts(json, "per_label", moves.per_label);
  write_texts(json, "labels", moves.labels);
  write_counts(json, "confusion", moves.confusion);
  write_counts(json, "steps", moves.steps);
  json.key("step_accuracy").value(moves.step_accuracy);
  json.key("by_chance").value(moves.by_chance);
}

std::string_view name_of(ZmpSettings::Segments segments) {
  switch (segments) {
    case ZmpSettings::Segments::Male:
      return "de Leva 1996, male";
    case ZmpSettings::Segments::Female:
      return "de Leva 1996, female";
    case ZmpSettings::Segments::Mean:
      break;
  }
  return "de Leva 1996, mean of male and female";
}

void write_zmp(JsonText& json, const ZmpTable& zmp) {
  const Object object(json, "zmp");
  const auto metres_and_units = [&](std::string_view original, std::string_view synthesised, double per_unit,
                                    double original_m, double synthesised_m) {
    json.key(original).value(original_m / per_unit);
    json.key(synthesised).value(synthesised_m / per_unit);
  };
  metres_and_units("original_m", "synthesised_m", 1, zmp.original_m, zmp.synthesised_m);
  metres_and_units("original_asf", "synthesised_asf", metres_per_asf_unit, zmp.original_m, zmp.synthesised_m);
  json.key("ratio").value(zmp.original_m > 0 ? zmp.synthesised_m / zmp.original_m
                                             : std::numeric_limits<double>::quiet_NaN());
  json.key("frames").value(zmp.frames);
  json.key("skipped_frames").value(zmp.skipped_frames);
  json.key("original_skipped_frames").value(zmp.original_skipped_frames);
  {
    const Object partner(json, "partner");
    metres_and_units("original_m", "synthesised_m", 1, zmp.original_partner_m, zmp.synthesised_partner_m);
    metres_and_units("original_asf", "synthesised_asf", metres_per_asf_unit, zmp.original_partner_m,
                     zmp.synthesised_partner_m);
  }
  {
    const Object between(json, "partner_between_changes");
    metres_and_units("original_m", "synthesised_m", 1, zmp.original_between_changes_m,
                     zmp.partner_between_changes_m);
    json.key("share_of_steps").value(zmp.between_changes_share);
  }
  const auto common = [&](std::string_view key, const CommonZmp& figures) {
    const Object frames(json, key);
    metres_and_units("original_m", "synthesised_m", 1, figures.first_m, figures.second_m);
    json.key("ratio").value(figures.second_m / figures.first_m);
    json.key("frames").value(figures.frames);
  };
  common("common_frames", zmp.common);
  common("partner_common_frames", zmp.common_partner);
  {
    const Object left_out(json, "partner_left_out");
    const auto frames = [&](std::string_view key, int original, int synthesised) {
      const Object counted(json, key);
      json.key("original").value(original);
      json.key("synthesised").value(synthesised);
    };
    frames("free_fall_frames", zmp.original_partner_free_fall, zmp.partner_free_fall);
    frames("no_support_frames", zmp.original_partner_no_support, zmp.partner_no_support);
    frames("frames_that_count", zmp.original_partner_frames, zmp.partner_frames);
  }
  const Object settings(json, "settings");
  json.key("segments").value(name_of(zmp.settings.segments));
  json.key("floor_m").value(zmp.settings.floor_m);
  json.key("contact_height_m").value(zmp.settings.contact_height_m);
  json.key("smoothing_s").value(zmp.settings.smoothing_s);
  json.key("sole_margin_m").value(zmp.settings.sole_margin_m);
}

void write_penetration(JsonText& json, std::string_view key, const PenetrationMetric::Figures& figures) {
  const Object object(json, key);
  json.key("deep_share").value(figures.deep_share);
  json.key("mean_m").value(figures.mean_m);
  json.key("p99_m").value(figures.p99_m);
  json.key("max_m").value(figures.max_m);
  json.key("excess_p99_m").value(figures.excess_p99_m);
  json.key("excess_max_m").value(figures.excess_max_m);
  json.key("frames").value(figures.frames);
}

void write_contact(JsonText& json, const ContactTable& contact) {
  const Object object(json, "contact");
  json.key("hold_change_mean_m").value(contact.holds.change_mean_m);
  json.key("hold_change_p95_m").value(contact.holds.change_p95_m);
  json.key("holds_kept").value(contact.holds.kept);
  json.key("hold_precision").value(contact.holds.precision);
  json.key("hold_f1").value(contact.holds.f1);
  json.key("holds").value(contact.holds.holds);
  json.key("penetration_excess_p99_m").value(contact.penetration.excess_p99_m);
  write_penetration(json, "penetration", contact.penetration);
  write_penetration(json, "original_penetration", contact.original_penetration);
  {
    const Object slide(json, "foot_slide_m_per_s");
    json.key("original").value(contact.original_foot_slide_m_s);
    json.key("synthesised").value(contact.foot_slide_m_s);
    json.key("user").value(contact.user_foot_slide_m_s);
  }
  json.key("bone_length_max").value(contact.bone_length_max);
  json.key("foot_lock_drift_max_m").value(contact.foot_lock_drift_max_m);
}

void write_continuity(JsonText& json, const ContinuityMetric::Figures& figures) {
  json.key("displacement_mean_m").value(figures.displacement_mean_m);
  json.key("displacement_p95_m").value(figures.displacement_p95_m);
  json.key("displacement_p99_m").value(figures.displacement_p99_m);
  json.key("displacement_max_m").value(figures.displacement_max_m);
  json.key("second_difference_mean_m").value(figures.second_difference_mean_m);
  json.key("second_difference_p99_m").value(figures.second_difference_p99_m);
}

void write_partner(JsonText& json, const PartnerTable& partner) {
  const Object object(json, "partner");
  json.key("mean_joint_error_m").value(partner.mean_joint_error_m);
  json.key("median_joint_error_m").value(partner.median_joint_error_m);
  json.key("p95_joint_error_m").value(partner.p95_joint_error_m);
  json.key("lag_ms").value(partner.lag_s * us_per_ms);
  json.key("lag_correlation").value(partner.lag_correlation);
  json.key("behind_selected_mean_m").value(partner.behind_selected_mean_m);
  json.key("source_changes_per_100").value(partner.continuity.source_changes_per_100);
  write_continuity(json, partner.continuity);
  const Object original(json, "original");
  write_continuity(json, partner.original_continuity);
}

/// Rows of one key stand together: "pace.p05" opens the object that "pace.p95" is the last of.
void write_movement_figures(JsonText& json, const MovementFigures& figures) {
  std::string_view open;
  for (const MovementRow& row : movement_rows()) {
    const std::size_t dot = row.key.find('.');
    const std::string_view group = dot == std::string_view::npos ? "" : row.key.substr(0, dot);
    if (!open.empty() && group != open) json.end_object();
    if (!group.empty() && group != open) json.key(group).begin_object();
    open = group;
    json.key(group.empty() ? row.key : row.key.substr(dot + 1));
    if (row.captured == nullptr) {
      json.value(figures.*row.made);
      continue;
    }
    json.begin_object();
    json.key("captured").value(figures.*row.captured);
    json.key("synthesised").value(figures.*row.made);
    json.end_object();
  }
  if (!open.empty()) json.end_object();
}

void write_movement(JsonText& json, const MovementTable& movement) {
  const Object object(json, "movement");
  write_movement_figures(json, movement.all);
  const Array array(json, "per_take");
  for (std::size_t t = 0; t < movement.takes.size(); ++t) {
    const Object take(json);
    json.key("take").value(movement.takes[t]);
    write_movement_figures(json, movement.per_take[t]);
  }
}

void write_published(JsonText& json, const PublishedTable& published) {
  const Object object(json, "published");
  json.key("clips").value(published.clips);
  for (const PublishedRow& row : published_rows()) {
    const Object figure(json, row.key);
    json.key("synthesised").value(published.made.*row.figure);
    json.key("nearest_neighbour").value(published.nearest.*row.figure);
    json.key("recording").value(published.captured.*row.figure);
  }
}

void write_contact_score(JsonText& json, std::string_view key, const ContactScore& score) {
  const Object object(json, key);
  json.key("precision").value(score.precision);
  json.key("recall").value(score.recall);
  json.key("f1").value(score.f1);
}

void write_posture(JsonText& json, std::string_view key, const PostureChange& posture) {
  const Object object(json, key);
  json.key("pelvis_height_ratio").value(posture.pelvis);
  json.key("knee_change_deg").value(posture.knee_deg);
  json.key("trunk_change_deg").value(posture.trunk_deg);
}

void write_bodies(JsonText& json, const BodyTable& bodies) {
  const Object object(json, "bodies");
  json.key("takes").value(bodies.takes);
  json.key("frames").value(bodies.frames);
  json.key("recorded_slide_m_per_s").value(bodies.recorded_slide_m_s);
  const Array array(json, "pairs");
  for (const BodyRow& row : bodies.rows) {
    const Object pair(json);
    json.key("bodies").value(row.bodies);
    for (std::size_t m = 0; m < row.methods.size(); ++m) {
      const BodyFigures& figures = row.methods[m];
      const Object method(json, body_method_keys[m]);
      write_contact_score(json, "contact_15cm", figures.within_15cm);
      write_contact_score(json, "contact_25cm", figures.within_25cm);
      write_posture(json, "posture_active", figures.posture[0]);
      write_posture(json, "posture_passive", figures.posture[1]);
      json.key("hold_change_mean_m").value(figures.hold_change_mean_m);
      json.key("hold_change_p95_m").value(figures.hold_change_p95_m);
      json.key("penetration_excess_p99_m").value(figures.penetration_excess_p99_m);
      json.key("floor_contact").value(figures.floor_contact);
      json.key("slide_m_per_s").value(figures.slide_m_s);
      json.key("slide_ratio").value(figures.slide_ratio);
      json.key("speed_p99_ratio").value(figures.speed_p99_ratio);
      json.key("acceleration_p99_ratio").value(figures.acceleration_p99_ratio);
      json.key("bone_error_max").value(figures.bone_error_max);
      json.key("nearest_only").value(figures.nearest_only);
    }
  }
}

void write_solve(JsonText& json, const SolveTimes& solve) {
  const Object object(json, "solve_us");
  json.key("p50").value(solve.p50_us);
  json.key("p95").value(solve.p95_us);
  json.key("p99").value(solve.p99_us);
  json.key("steps").value(solve.steps);
  json.key("relaxed").value(solve.relaxed);
  json.key("failed").value(solve.failed);
}

void write_users(JsonText& json, std::string_view key, const Evaluation& evaluation,
                 const std::vector<UserResult>& users) {
  if (users.empty()) return;
  const Array array(json, key);
  for (const UserResult& user : users) {
    const Object object(json);
    json.key("name").value(user.user);
    if (evaluation.has_moves) write_moves(json, user.moves);
    if (evaluation.has_contact) write_contact(json, user.contact);
    write_partner(json, user.partner);
    write_movement(json, user.movement);
    if (evaluation.has_zmp && user.zmp.frames > 0) write_zmp(json, user.zmp);
    write_solve(json, user.solve);
  }
}

void write_what_was_run(JsonText& json, const Evaluation& evaluation) {
  json.key("abrazo_report").value(1);
  json.key("version").value(version());
  json.key("data").value(evaluation.data);
  if (!evaluation.users.empty()) json.key("users").value(evaluation.users);
  json.key("both_roles").value(evaluation.both_roles);
  write_texts(json, "takes", evaluation.takes);
  json.key("library_pairs").value(evaluation.library_pairs);
  json.key("step_rate_hz");
  evaluation.step_rate_hz > 0 ? json.value(evaluation.step_rate_hz) : json.null();
  write_texts(json, "remarks", evaluation.remarks);
  json.key("seconds").value(evaluation.seconds);
}

}  // namespace

std::string report_json(const Evaluation& evaluation) {
  JsonText json;
  json.begin_object();
  write_what_was_run(json, evaluation);
  write_selection(json, evaluation.selection);
  write_timing(json, evaluation.timing);
  if (evaluation.result) {
    const UserResult& result = *evaluation.result;
    if (evaluation.has_moves) write_moves(json, result.moves);
    if (evaluation.has_zmp) write_zmp(json, result.zmp);
    if (evaluation.has_contact) write_contact(json, result.contact);
    write_partner(json, result.partner);
    write_movement(json, result.movement);
    if (result.published) write_published(json, *result.published);
    write_solve(json, result.solve);
  }
  if (evaluation.bodies) write_bodies(json, *evaluation.bodies);
  write_users(json, "builds", evaluation, evaluation.builds);
  write_users(json, "disturbed", evaluation, evaluation.disturbed);
  return finished_with_settings(json, evaluation.settings);
}

std::string finished_with_settings(JsonText& json, const Settings& settings) {
  json.end_object();
  std::string text = json.take();
  text.pop_back();
  return text + ",\"settings\":" + settings_json(settings) + "}";
}

}  // namespace abrazo
