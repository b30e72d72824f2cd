#pragma once

#include <string>
#include <vector>

#include "core/metrics/run_comparison.hpp"

namespace abrazo::widgets {

enum class Better { Neither, A, B };

/// One figure of two runs, as it is written.
struct FigureRow {
  std::string name, unit, help;
  std::string a, b;                 ///< "—" where there is nothing to measure
  std::string difference;           ///< B less A, with its sign; empty where one is missing
  Better better = Better::Neither;  ///< neither where both are written alike
};

FigureRow figure_row(RunFigure figure, const RunFigures& a, const RunFigures& b);
/// Every figure, in the order of RunFigure.
std::vector<FigureRow> figure_rows(const RunFigures& a, const RunFigures& b);

/// A setting in which two runs differ: "w_Δ 0.2".
struct DifferingSetting {
  std::string name, value;
};
/// Those of `own` that are not as in `other`, in the order of the settings panel.
std::vector<DifferingSetting> differing_settings(const Settings& own, const Settings& other);
/// In one line; "as preset paper", say, or "same settings" where nothing differs.
std::string settings_line(const Settings& own, const Settings& other);

}  // namespace abrazo::widgets
