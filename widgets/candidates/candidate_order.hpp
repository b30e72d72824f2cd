#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "widgets/candidates/candidate_rows.hpp"

namespace abrazo::widgets {

/// What the table can be sorted by. Which terms there are depends on the method that decided.
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
  Total,
  Distance
};

/// From left to right; the total and the distance are last.
std::span<const CandidateColumn> candidate_columns(SelectionMethod method);

/// The term that a column shows; nothing for the others.
std::optional<CostTerm> term_of(CandidateColumn column);
CandidateColumn column_of(CostTerm term);

/// "rank", "take and frame", "temporal cost of the leader", ...
std::string_view column_title(CandidateColumn column);

struct CandidateOrder {
  CandidateColumn column = CandidateColumn::Rank;
  bool descending = false;
  bool operator==(const CandidateOrder&) const = default;
};

/// A column that is asked for again turns around; another one starts ascending.
CandidateOrder order_after_click(const CandidateOrder& order, CandidateColumn column);

/// What of an order can be done where this method decided: by rank when its column is one of another method.
CandidateOrder order_within(const CandidateOrder& order, SelectionMethod method);

/// Ties stand by rank, whichever way the column goes.
void sort_rows(std::vector<CandidateRow>& rows, const CandidateOrder& order);

/// The figure at the end of a row: that of the sorted column if it is one, else the total.
double shown_figure(const CandidateRow& row, CandidateColumn column);
/// " m", or nothing where all figures of the table are in m^2.
std::string_view figure_unit(const CandidateRow& row, CandidateColumn column);

}  // namespace abrazo::widgets
