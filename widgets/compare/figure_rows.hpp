#pragma once

#include <string>
#include <vector>

#include "core/metrics/run_comparison.hpp"

namespace abrazo::widgets {

enum class Better { Neither, A, B };

/// One figure of two runs as text.
struct FigureRow {
  std::string name, unit, help;
  std::string a, b;                 ///< "—" = nothing to measure
  std::string difference;           ///< B minus A, with its sign; empty if one is missing
  Better better = Better::Neither;  ///< Neither if both texts are equal

  bool operator==(const FigureRow&) const = default;
};

FigureRow figure_row(RunFigure figure, const RunFigures& a, const RunFigures& b);
/// Every figure, in the order of RunFigure.
std::vector<FigureRow> figure_rows(const RunFigures& a, const RunFigures& b);

/// A setting in which two runs differ: "w_Δ 0.2".
struct DifferingSetting {
  std::string name, value;
};
/// Settings of `own` that differ from `other`, in the order of the settings panel.
std::vector<DifferingSetting> differing_settings(const Settings& own, const Settings& other);
/// One line: the differing settings, "as preset paper", or "same settings".
std::string settings_line(const Settings& own, const Settings& other);

}  // namespace abrazo::widgets
