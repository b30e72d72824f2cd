#include "core/evaluation/sweep/sweep_metric.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "core/base/text.hpp"
#include "core/evaluation/report/report_json.hpp"

namespace abrazo {

namespace {

constexpr std::array<std::string_view, 7> groups = {"moves",    "zmp",       "contact", "partner",
                                                    "movement", "published", "solve_us"};

/// A figure of report.json, or all of an object, whose name then ends with a dot.
struct StatedGoal {
  std::string_view name;
  FigureGoal goal;
};

/// Of the tables without rows of their own. Of several that fit the first counts.
constexpr std::array stated_goals = {
    StatedGoal{"moves.", FigureGoal::Highest},
    StatedGoal{"contact.bone_length_max", FigureGoal::Lowest},
    StatedGoal{"contact.foot_lock_drift_max_m", FigureGoal::Lowest},
    StatedGoal{"contact.foot_slide_m_per_s.", FigureGoal::Lowest},
    StatedGoal{"contact.hold_change_mean_m", FigureGoal::Lowest},
    StatedGoal{"contact.hold_change_p95_m", FigureGoal::Lowest},
    StatedGoal{"contact.hold_f1", FigureGoal::Highest},
    StatedGoal{"contact.hold_precision", FigureGoal::Highest},
    StatedGoal{"contact.holds", FigureGoal::Highest},
    StatedGoal{"contact.holds_kept", FigureGoal::Highest},
    StatedGoal{"contact.original_penetration.", FigureGoal::Lowest},
    StatedGoal{"contact.penetration.", FigureGoal::Lowest},
    StatedGoal{"contact.penetration_excess_p99_m", FigureGoal::Lowest},
    StatedGoal{"partner.behind_selected_mean_m", FigureGoal::Lowest},
    StatedGoal{"partner.displacement_max_m", FigureGoal::Lowest},
    StatedGoal{"partner.displacement_mean_m", FigureGoal::Lowest},
    StatedGoal{"partner.displacement_p95_m", FigureGoal::Lowest},
    StatedGoal{"partner.displacement_p99_m", FigureGoal::Lowest},
    StatedGoal{"partner.lag_correlation", FigureGoal::Highest},
    StatedGoal{"partner.lag_ms", FigureGoal::NearestZero},
    StatedGoal{"partner.mean_joint_error_m", FigureGoal::Lowest},
    StatedGoal{"partner.median_joint_error_m", FigureGoal::Lowest},
    StatedGoal{"partner.original.", FigureGoal::Lowest},
    StatedGoal{"partner.p95_joint_error_m", FigureGoal::Lowest},
    StatedGoal{"partner.second_difference_mean_m", FigureGoal::Lowest},
    StatedGoal{"partner.second_difference_p99_m", FigureGoal::Lowest},
    StatedGoal{"partner.source_changes_per_100", FigureGoal::Lowest},
    StatedGoal{"published.clips", FigureGoal::None},
    StatedGoal{"solve_us.failed", FigureGoal::Lowest},
    StatedGoal{"solve_us.p50", FigureGoal::Lowest},
    StatedGoal{"solve_us.p95", FigureGoal::Lowest},
    StatedGoal{"solve_us.p99", FigureGoal::Lowest},
    StatedGoal{"solve_us.relaxed", FigureGoal::Lowest},
    StatedGoal{"solve_us.steps", FigureGoal::Lowest},
    StatedGoal{"zmp.common_frames.", FigureGoal::Lowest},
    StatedGoal{"zmp.frames", FigureGoal::Lowest},
    StatedGoal{"zmp.original_asf", FigureGoal::Lowest},
    StatedGoal{"zmp.original_m", FigureGoal::Lowest},
    StatedGoal{"zmp.original_skipped_frames", FigureGoal::Lowest},
    StatedGoal{"zmp.partner.", FigureGoal::Lowest},
    StatedGoal{"zmp.partner_between_changes.", FigureGoal::Lowest},
    StatedGoal{"zmp.partner_common_frames.", FigureGoal::Lowest},
    StatedGoal{"zmp.partner_left_out.", FigureGoal::Lowest},
    StatedGoal{"zmp.ratio", FigureGoal::Lowest},
    StatedGoal{"zmp.settings.", FigureGoal::None},
    StatedGoal{"zmp.skipped_frames", FigureGoal::Lowest},
    StatedGoal{"zmp.synthesised_asf", FigureGoal::Lowest},
    StatedGoal{"zmp.synthesised_m", FigureGoal::Lowest},
};

/// "slide_m_per_s" is the row of "slide_m_per_s" and of "slide_m_per_s.captured".
bool is_of_row(std::string_view figure, std::string_view row) {
  return figure.starts_with(row) && (figure.size() == row.size() || figure[row.size()] == '.');
}

/// A figure that is best near the recording's has no best value of its own.
FigureGoal goal_of_published(PublishedRow::Better better) {
  switch (better) {
    case PublishedRow::Better::Lower:
      return FigureGoal::Lowest;
    case PublishedRow::Better::Higher:
      return FigureGoal::Highest;
    case PublishedRow::Better::AsRecorded:
      break;
  }
  return FigureGoal::None;
}

/// Nothing where none is stated: a figure that was added without one.
std::optional<FigureGoal> stated_goal(std::string_view metric) {
  constexpr std::string_view movement = "movement.", published = "published.";
  if (metric.starts_with(movement))
    for (const MovementRow& row : movement_rows())
      if (is_of_row(metric.substr(movement.size()), row.key)) return row.goal;
  if (metric.starts_with(published))
    for (const PublishedRow& row : published_rows())
      if (is_of_row(metric.substr(published.size()), row.key)) return goal_of_published(row.better);
  for (const StatedGoal& stated : stated_goals)
    if (stated.name.ends_with('.') ? metric.starts_with(stated.name) : metric == stated.name)
      return stated.goal;
  return std::nullopt;
}

void collect(const nlohmann::json& value, const std::string& path, Figures& figures) {
  if (value.is_number()) figures[path] = value.get<double>();
  if (value.is_object())
    for (const auto& [key, inner] : value.items()) collect(inner, path + "." + key, figures);
}

bool depends_on_data(std::string_view metric) {
  return metric.starts_with("moves.per_label.") || metric.starts_with("moves.per_take.");
}

/// An evaluation in which every figure is defined.
Evaluation complete_evaluation() {
  Evaluation evaluation;
  evaluation.result.emplace();
  evaluation.result->published.emplace();
  evaluation.result->moves.all.total = 1;
  ZmpTable& zmp = evaluation.result->zmp;
  zmp.original_m = zmp.common.first_m = zmp.common_partner.first_m = zmp.partner_frames = 1;
  evaluation.has_moves = evaluation.has_zmp = evaluation.has_contact = true;
  return evaluation;
}

}  // namespace

Figures figures_of(const Evaluation& evaluation) {
  const nlohmann::json report = nlohmann::json::parse(report_json(evaluation));
  Figures figures;
  for (const std::string_view group : groups)
    if (const auto found = report.find(std::string(group)); found != report.end())
      collect(*found, std::string(group), figures);
  std::erase_if(figures, [](const auto& figure) { return stated_goal(figure.first) == FigureGoal::None; });
  return figures;
}

std::set<EvaluationPart> sweep_parts() {
  return {EvaluationPart::Moves, EvaluationPart::Zmp, EvaluationPart::Contact, EvaluationPart::Published};
}

std::vector<std::string> metric_names() {
  std::vector<std::string> names;
  for (const auto& [name, value] : figures_of(complete_evaluation())) names.push_back(name);
  return names;
}

Status check_metric(std::string_view metric) {
  const std::vector<std::string> names = metric_names();
  if (depends_on_data(metric) || std::find(names.begin(), names.end(), metric) != names.end()) return Done{};
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return Error{fmt::format("{} is not a figure of report.json that a sweep can be about; there are {}, and "
                           "moves.per_label.LABEL.rate",
                           in_quotes(metric), list),
               "", Hint::ChooseMetric};
}

FigureGoal goal_of(std::string_view metric) {
  const auto goal = stated_goal(metric);
  if (!goal) throw std::invalid_argument("no goal is stated for the figure " + std::string(metric));
  return *goal;
}

bool is_better(FigureGoal goal, double a, double b) {
  switch (goal) {
    case FigureGoal::Highest:
      return a > b;
    case FigureGoal::NearestZero:
      return std::abs(a) < std::abs(b);
    case FigureGoal::Lowest:
      return a < b;
    case FigureGoal::None:
      break;
  }
  return false;
}

}  // namespace abrazo
