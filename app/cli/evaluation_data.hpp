#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/evaluation/evaluate.hpp"

namespace abrazo::app {

/// Which takes an evaluation or a sweep is made on.
struct EvaluationSource {
  std::string manifest, users;
  bool both_roles = false;
};

void add_evaluation_source(CLI::App& command, EvaluationSource& source);

Result<EvaluationData> read_evaluation_data(const EvaluationSource& source, const Progress& progress);

/// Makes a folder for a report, asked before the work rather than after it.
Status make_folder(const std::string& folder);

}  // namespace abrazo::app
