#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/evaluation/run/evaluate.hpp"
#include "core/evaluation/tables/evaluation.hpp"
#include "core/evaluation/tables/figure_goal.hpp"

namespace abrazo {

/// Numbers of report.json by their path, as in "partner.lag_ms".
using Figures = std::map<std::string, double>;

/// All numbers under moves, zmp, contact, partner, movement, published and solve_us; those that are not
/// defined (null) are missing.
Figures figures_of(const Evaluation& evaluation);

/// Parts that have to be evaluated for the figures: one synthesis gives them all.
std::set<EvaluationPart> sweep_parts();

/// Possible metrics of a sweep, except those per label and per take, which depend on the data.
std::vector<std::string> metric_names();

/// An Error lists the names.
Status check_metric(std::string_view metric);

/// Which value of a figure is best, as its row or the table in sweep_metric.cpp states.
/// @throws std::invalid_argument for a figure that states none
FigureGoal goal_of(std::string_view metric);
bool is_better(FigureGoal goal, double a, double b);

}  // namespace abrazo
