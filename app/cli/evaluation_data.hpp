#pragma once

#include <CLI/CLI.hpp>

#include "app/cli/command_line.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/evaluation/run/evaluation_source.hpp"

namespace abrazo::app {

void add_evaluation_source(CLI::App& command, EvaluationSource& source);

/// Reads the takes and their library. Warnings go to stderr.
Result<EvaluationData> read_takes(CommandLine& line, const EvaluationManifests& manifests, bool both_roles,
                                  const Progress& progress);

}  // namespace abrazo::app
