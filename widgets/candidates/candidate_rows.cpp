#include "widgets/candidates/candidate_rows.hpp"

#include <algorithm>

namespace abrazo::widgets {
namespace {

void read_paper(const Candidate& candidate, double alpha, CandidateRow& row) {
  const CostBreakdown& cost = candidate.cost;
  row.terms = {cost.pose, alpha * cost.temporal_active, alpha * cost.temporal_passive};
  row.total = cost.total;
}

void read_intent(const Candidate& candidate, const FrameIntent& intent, CandidateRow& row) {
  const IntentCost& cost = *candidate.intent;
  row.terms = {cost.partner, cost.leader, cost.move, cost.meant, cost.change, cost.temporal};
  row.total = cost.total;
  row.continues_source = candidate.continuation || candidate.pair == intent.continued;
}

}  // namespace

std::vector<CandidateRow> candidate_rows(const FrameSnapshot& frame, const MotionLibrary& library) {
  const FrameResult& result = frame.result;
  const SelectionMethod method = deciding_method(result).value_or(SelectionMethod::Paper);
  std::vector<CandidateRow> rows;
  for (std::size_t c = 0; c < result.candidates.size(); ++c) {
    const Candidate& candidate = result.candidates[c];
    if (candidate.pair < 0 || candidate.pair >= library.pair_count()) continue;
    CandidateRow row;
    row.candidate = static_cast<int>(c);
    row.pair = candidate.pair;
    row.take_index = static_cast<int>(library.source(candidate.pair).take);
    row.take = library.take_of(candidate.pair).name;
    row.frame = static_cast<int>(library.source(candidate.pair).frame);
    row.swapped = library.source(candidate.pair).swapped;
    row.label = library.label(candidate.pair);
    row.method = method;
    if (method == SelectionMethod::Intent)
      read_intent(candidate, result.intent, row);
    else
      read_paper(candidate, frame.settings.alpha, row);
    row.equation_7 = candidate.cost.total;
    row.feature_distance = candidate.feature_distance;
    row.selected = row.candidate == result.selected;
    rows.push_back(std::move(row));
  }
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.total < b.total; });
  int rank = 0;
  for (CandidateRow& row : rows) row.rank = ++rank;
  return rows;
}

double value_of(const CandidateRow& row, CostTerm term) {
  const auto place = place_of(term, row.method);
  return place ? row.terms[*place] : 0;
}

std::array<double, most_cost_terms> bar_ends(const CandidateRow& row, double largest_total, double least) {
  constexpr double least_part = 5e-5;  // what reads 0.0000 is not there
  std::array<double, most_cost_terms> ends{};
  if (!(largest_total > 0)) return ends;
  const double room = 1 - least * static_cast<double>(ends.size());
  double end = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (row.terms[i] >= least_part) end += least;
    ends[i] = end += room * row.terms[i] / largest_total;
  }
  return ends;
}

}  // namespace abrazo::widgets
