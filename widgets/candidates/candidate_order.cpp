#include "widgets/candidates/candidate_order.hpp"

#include <algorithm>
#include <array>
#include <compare>
#include <tuple>

namespace abrazo::widgets {
namespace {

using enum CandidateColumn;

constexpr std::array<CandidateColumn, 8> paper_columns = {Rank,   Source,  Label, Pose,
                                                          Active, Passive, Total, Distance};
constexpr std::array<CandidateColumn, 11> intent_columns = {Rank,  Source, Label,    Partner, Leader,  Move,
                                                            Meant, Change, Temporal, Total,   Distance};

/// Negative, zero or positive, as strcmp.
int compare(const CandidateRow& a, const CandidateRow& b, CandidateColumn column) {
  const auto sign = [](std::partial_ordering order) {
    return std::is_lt(order) ? -1 : std::is_gt(order) ? 1 : 0;
  };
  switch (column) {
    case Rank:
      return a.rank - b.rank;
    case Source:
      return sign(std::tie(a.take, a.frame, a.swapped) <=> std::tie(b.take, b.frame, b.swapped));
    case Label:
      return sign(a.label <=> b.label);
    default:
      return sign(shown_figure(a, column) <=> shown_figure(b, column));
  }
}

}  // namespace

std::span<const CandidateColumn> candidate_columns(SelectionMethod method) {
  if (method == SelectionMethod::Intent) return intent_columns;
  return paper_columns;
}

std::optional<CostTerm> term_of(CandidateColumn column) {
  if (column < Pose || column > Temporal) return std::nullopt;
  return static_cast<CostTerm>(static_cast<int>(column) - static_cast<int>(Pose));
}

CandidateColumn column_of(CostTerm term) {
  return static_cast<CandidateColumn>(static_cast<int>(term) + static_cast<int>(Pose));
}

std::string_view column_title(CandidateColumn column) {
  if (const auto term = term_of(column)) return info_of(*term).title;
  switch (column) {
    case Rank:
      return "rank";
    case Source:
      return "take and frame";
    case Label:
      return "move";
    case Distance:
      return "feature distance";
    default:
      return "total cost";
  }
}

CandidateOrder order_after_click(const CandidateOrder& order, CandidateColumn column) {
  return {column, order.column == column && !order.descending};
}

CandidateOrder order_within(const CandidateOrder& order, SelectionMethod method) {
  return std::ranges::count(candidate_columns(method), order.column) > 0 ? order : CandidateOrder{};
}

void sort_rows(std::vector<CandidateRow>& rows, const CandidateOrder& order) {
  std::sort(rows.begin(), rows.end(), [&](const CandidateRow& a, const CandidateRow& b) {
    const int found = compare(a, b, order.column);
    if (found == 0) return a.rank < b.rank;
    return order.descending ? found > 0 : found < 0;
  });
}

double shown_figure(const CandidateRow& row, CandidateColumn column) {
  if (const auto term = term_of(column)) return value_of(row, *term);
  return column == Distance ? row.feature_distance : row.total;
}

std::string_view figure_unit(const CandidateRow& row, CandidateColumn column) {
  return column == Distance || row.method == SelectionMethod::Intent ? " m" : " m²";
}

}  // namespace abrazo::widgets
