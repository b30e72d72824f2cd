#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "widgets/candidates/candidate_rows.hpp"

namespace abrazo::widgets {

/// What the table can be sorted by.
enum class CandidateColumn { Rank, Source, Label, Pose, Active, Passive, Total, Distance };

inline constexpr std::array<CandidateColumn, 8> candidate_columns = {
    CandidateColumn::Rank,   CandidateColumn::Source,  CandidateColumn::Label, CandidateColumn::Pose,
    CandidateColumn::Active, CandidateColumn::Passive, CandidateColumn::Total, CandidateColumn::Distance};

/// "rank", "take and frame", "temporal cost of the leader", ...
std::string_view column_title(CandidateColumn column);

struct CandidateOrder {
  CandidateColumn column = CandidateColumn::Rank;
  bool descending = false;
  bool operator==(const CandidateOrder&) const = default;
};

/// A column that is asked for again turns around; another one starts ascending.
CandidateOrder order_after_click(const CandidateOrder& order, CandidateColumn column);

/// Ties stand by rank, whichever way the column goes.
void sort_rows(std::vector<CandidateRow>& rows, const CandidateOrder& order);

/// The figure at the end of a row: that of the sorted column if it is one, else the total. Costs [m^2], the
/// distance [m].
double shown_figure(const CandidateRow& row, CandidateColumn column);

}  // namespace abrazo::widgets
