#pragma once

#include <string>

#include "core/evaluation/tables/evaluation.hpp"

namespace abrazo {

/// One self-contained page: each table with the paper's values, with plots (SVG) and explanations of
/// the differences. For a reader who knows the paper.
std::string report_html(const Evaluation& evaluation);

}  // namespace abrazo
