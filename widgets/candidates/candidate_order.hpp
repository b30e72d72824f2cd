#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "widgets/candidates/candidate_rows.hpp"

namespace abrazo::widgets {

/// Sort columns of the table. The terms depend on the deciding method.
enum class CandidateColumn {
  Rank,
  Source,
  Label,
  Pose,
  Active,
  Passive,
  Partner,
  Leader,
  Move,
  Meant,
  Change,
  Temporal,
  Total,
  Distance
};

/// From left to right; the total and the distance are last.
std::span<const CandidateColumn> candidate_columns(SelectionMethod method);

/// The term of a column; none for other columns.
std::optional<CostTerm> term_of(CandidateColumn column);
CandidateColumn column_of(CostTerm term);

/// "rank", "take and frame", "temporal cost of the leader", ...
std::string_view column_title(CandidateColumn column);

struct CandidateOrder {
  CandidateColumn column = CandidateColumn::Rank;
  bool descending = false;
  bool operator==(const CandidateOrder&) const = default;
};

/// A second click on a column reverses the order; another column starts ascending.
CandidateOrder order_after_click(const CandidateOrder& order, CandidateColumn column);

/// The order for a method: by rank if the column belongs to another method.
CandidateOrder order_within(const CandidateOrder& order, SelectionMethod method);

/// Ties are ordered by rank in both directions.
void sort_rows(std::vector<CandidateRow>& rows, const CandidateOrder& order);

/// The figure at the end of a row: that of the sorted column if it is a figure, else the total.
double shown_figure(const CandidateRow& row, CandidateColumn column);
/// " m" or " m²".
std::string_view figure_unit(const CandidateRow& row, CandidateColumn column);

}  // namespace abrazo::widgets
