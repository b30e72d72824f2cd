#pragma once

#include <string>

#include "core/evaluation/sweep/sweep.hpp"

namespace abrazo {

/// The command-line options for the settings of a point: the nearest preset and the differences from it.
std::string settings_options(const Settings& settings);

/// The point with the best value of the metric; the first of equals. None if no point has a value.
std::optional<int> best_point(const Sweep& sweep, const std::vector<Figures>& points);

/// sweep.json of a complete sweep.
std::string sweep_json(const SweepOutcome& outcome);

/// One self-contained page: heat map with the best point marked, the best points with their other figures,
/// and how to use them.
std::string sweep_html(const SweepOutcome& outcome);

}  // namespace abrazo
