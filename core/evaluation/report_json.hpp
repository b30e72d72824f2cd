#pragma once

#include <string>

#include "core/evaluation/evaluation.hpp"

namespace abrazo {

/// report.json as the contract has it, with further keys beside. Parts that were not asked for are missing;
/// what is not defined (a success rate of no moves) is null.
std::string report_json(const Evaluation& evaluation);

}  // namespace abrazo
