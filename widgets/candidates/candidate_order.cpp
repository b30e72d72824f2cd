#include "widgets/candidates/candidate_order.hpp"

#include <algorithm>
#include <compare>
#include <tuple>

namespace abrazo::widgets {
namespace {

/// Negative, zero or positive, as strcmp.
int compare(const CandidateRow& a, const CandidateRow& b, CandidateColumn column) {
  const auto sign = [](std::partial_ordering order) {
    return std::is_lt(order) ? -1 : std::is_gt(order) ? 1 : 0;
  };
  switch (column) {
    case CandidateColumn::Rank:
      return a.rank - b.rank;
    case CandidateColumn::Source:
      return sign(std::tie(a.take, a.frame, a.swapped) <=> std::tie(b.take, b.frame, b.swapped));
    case CandidateColumn::Label:
      return sign(a.label <=> b.label);
    default:
      return sign(shown_figure(a, column) <=> shown_figure(b, column));
  }
}

}  // namespace

std::string_view column_title(CandidateColumn column) {
  static constexpr std::array<std::string_view, 8> titles = {"rank",
                                                             "take and frame",
                                                             "move",
                                                             "pose cost",
                                                             "temporal cost of the leader",
                                                             "temporal cost of the follower",
                                                             "total cost",
                                                             "feature distance"};
  return titles[static_cast<std::size_t>(column)];
}

CandidateOrder order_after_click(const CandidateOrder& order, CandidateColumn column) {
  return {column, order.column == column && !order.descending};
}

void sort_rows(std::vector<CandidateRow>& rows, const CandidateOrder& order) {
  std::sort(rows.begin(), rows.end(), [&](const CandidateRow& a, const CandidateRow& b) {
    const int found = compare(a, b, order.column);
    if (found == 0) return a.rank < b.rank;
    return order.descending ? found > 0 : found < 0;
  });
}

double shown_figure(const CandidateRow& row, CandidateColumn column) {
  switch (column) {
    case CandidateColumn::Pose:
      return row.pose;
    case CandidateColumn::Active:
      return row.active;
    case CandidateColumn::Passive:
      return row.passive;
    case CandidateColumn::Distance:
      return row.feature_distance;
    default:
      return row.total;
  }
}

}  // namespace abrazo::widgets
