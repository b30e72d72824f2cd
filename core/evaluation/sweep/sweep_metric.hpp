#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/evaluation/run/evaluate.hpp"
#include "core/evaluation/tables/evaluation.hpp"

namespace abrazo {

/// Numbers of report.json by their path, as in "partner.lag_ms".
using Figures = std::map<std::string, double>;

/// All numbers under moves, zmp, contact, partner, movement, published and solve_us; those that are not
/// defined (null) are missing.
Figures figures_of(const Evaluation& evaluation);

/// What has to be evaluated for the figures: one synthesis gives them all.
std::set<EvaluationPart> sweep_parts();

/// The paths a sweep can be about, but for those per label and per take, which depend on the data.
std::vector<std::string> metric_names();

/// An Error lists the names.
Status check_metric(std::string_view metric);

enum class MetricGoal { Lowest, Highest, NearestZero };
/// Which value of a metric is best. Rates and shares of what is right: the highest; lag: the nearest to zero.
MetricGoal goal_of(std::string_view metric);
bool is_better(MetricGoal goal, double a, double b);

}  // namespace abrazo
