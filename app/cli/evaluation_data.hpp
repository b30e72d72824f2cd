#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command_line.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/evaluation/evaluate.hpp"

namespace abrazo::app {

/// Which takes an evaluation or a sweep is made on.
struct EvaluationSource {
  std::string manifest, users;
  bool both_roles = false;
  std::vector<std::string> hold_out;
};

void add_evaluation_source(CLI::App& command, EvaluationSource& source);

/// The manifests of a source: read, and checked for the takes to be answered, in no time.
struct EvaluationManifests {
  Manifest manifest;
  std::optional<Manifest> users;
};

Result<EvaluationManifests> read_manifests(const EvaluationSource& source);

/// The takes themselves and their library. What was odd about them is said on stderr.
Result<EvaluationData> read_takes(CommandLine& line, const EvaluationManifests& manifests, bool both_roles,
                                  const Progress& progress);

}  // namespace abrazo::app
