#pragma once

#include <string>

#include "core/evaluation/tables/evaluation.hpp"

namespace abrazo {

/// One self-contained page: each table beside the paper's printed values, with plots (SVG) and what explains
/// the differences. For a reader who knows the paper.
std::string report_html(const Evaluation& evaluation);

}  // namespace abrazo
