#include "core/evaluation/sweep/sweep_metric.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/text.hpp"
#include "core/evaluation/report/report_json.hpp"

namespace abrazo {

namespace {

constexpr std::array<std::string_view, 7> groups = {"moves",    "zmp",       "contact", "partner",
                                                    "movement", "published", "solve_us"};

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
  // Nothing is better for a higher or a lower one of these.
  std::erase_if(figures, [](const auto& figure) {
    return figure.first.starts_with("zmp.settings.") || figure.first == "published.clips" ||
           figure.first.starts_with("movement.pace.p");
  });
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

MetricGoal goal_of(std::string_view metric) {
  if (metric == "partner.lag_ms" || metric == "movement.lag_s") return MetricGoal::NearestZero;
  constexpr std::array<std::string_view, 16> high = {"lenient_rate",
                                                     "rate",
                                                     "successful",
                                                     "lenient",
                                                     "step_accuracy",
                                                     "by_chance",
                                                     "holds_kept",
                                                     "hold_precision",
                                                     "hold_f1",
                                                     "lag_correlation",
                                                     "holds",
                                                     "total",
                                                     "captured_holds_held",
                                                     "captured_hold_recall",
                                                     "captured_hold_precision",
                                                     "own_share"};
  for (const PublishedRow& row : published_rows())
    if (metric.starts_with("published.") && metric.substr(10).starts_with(row.key))
      return row.better == PublishedRow::Better::Higher ? MetricGoal::Highest : MetricGoal::Lowest;
  const std::string_view last = metric.substr(metric.rfind('.') + 1);
  const bool highest = std::find(high.begin(), high.end(), last) != high.end();
  return highest ? MetricGoal::Highest : MetricGoal::Lowest;
}

bool is_better(MetricGoal goal, double a, double b) {
  switch (goal) {
    case MetricGoal::Highest:
      return a > b;
    case MetricGoal::NearestZero:
      return std::abs(a) < std::abs(b);
    case MetricGoal::Lowest:
      break;
  }
  return a < b;
}

}  // namespace abrazo
