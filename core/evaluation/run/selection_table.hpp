#pragma once

#include <span>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/evaluation/run/evaluate.hpp"
#include "core/evaluation/tables/evaluation.hpp"

namespace abrazo {

/// Table I: `options.queries` poses of the users, drawn at random, each searched in the library (without its
/// own take, if takes are left out one by one), at the library's full rate and thinned to 15 Hz.
/// @return an Error "cancelled" if `progress` cancels
Result<std::vector<SelectionTable>> measure_selection(const EvaluationData& data,
                                                      const EvaluationOptions& options,
                                                      const Progress& progress);

/// Table II: one selection with k = 10 and with brute force, for libraries of 7 500 pairs to
/// `options.largest_library`. Pairs beyond those of the takes are generated dances. The longest take gives
/// the queries and is not searched.
Result<std::vector<TimingRow>> measure_timing(const EvaluationData& data, const EvaluationOptions& options,
                                              const Progress& progress);

}  // namespace abrazo
