#include "core/evaluation/report/html_paper.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/text.hpp"

namespace abrazo {

namespace paper {

const SelectionRow* selection_row(int k) {
  const auto found =
      std::find_if(table_1.begin(), table_1.end(), [k](const auto& row) { return row.k == k; });
  return found == table_1.end() ? nullptr : &*found;
}

const TimingRow* timing_row(int pairs) {
  const auto found =
      std::find_if(table_2.begin(), table_2.end(), [pairs](const auto& row) { return row.pairs == pairs; });
  return found == table_2.end() ? nullptr : &*found;
}

}  // namespace paper

Style style_of(const Evaluation& evaluation) {
  Style style;
  if (!evaluation.result) return style;
  const auto names = [](const std::string& label, auto... parts) {
    return ((label.find(parts) != std::string::npos) || ...);
  };
  for (const auto& [label, count] : evaluation.result->moves.per_label) {
    const std::string low = lower_case(label);
    style.dance = style.dance || names(low, "hold", "turn", "cross_body", "walk", "in_and_out");
    style.fight = style.fight || names(low, "punch", "kick", "block", "dodg");
  }
  return style;
}

ShareInterval share_interval(int part, int total) {
  if (total <= 0) return {};
  constexpr double z = 1.959964;  // 97.5 % of the normal distribution lie below
  const double n = total, p = part / n;
  const double centre = (p + z * z / (2 * n)) / (1 + z * z / n);
  const double half = z / (1 + z * z / n) * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  return {std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

}  // namespace abrazo
