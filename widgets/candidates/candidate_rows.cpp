#include "widgets/candidates/candidate_rows.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>

namespace abrazo::widgets {
namespace {

/// Three decimals, four where that would read 0.000.
std::string figure(double value) {
  char text[32];
  std::snprintf(text, sizeof text, value != 0 && value < 0.0005 ? "%.4f" : "%.3f", value);
  return text;
}

}  // namespace

std::vector<CandidateRow> candidate_rows(const FrameSnapshot& frame, const MotionLibrary& library) {
  const FrameResult& result = frame.result;
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
    row.pose = candidate.cost.pose;
    row.active = frame.settings.alpha * candidate.cost.temporal_active;
    row.passive = frame.settings.alpha * candidate.cost.temporal_passive;
    row.total = candidate.cost.total;
    row.feature_distance = candidate.feature_distance;
    row.selected = row.candidate == result.selected;
    rows.push_back(std::move(row));
  }
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.total < b.total; });
  int rank = 0;
  for (CandidateRow& row : rows) row.rank = ++rank;
  return rows;
}

BarEnds bar_ends(const CandidateRow& row, double largest_total) {
  if (!(largest_total > 0)) return {0, 0, 0};
  const double pose = row.pose / largest_total;
  const double active = pose + row.active / largest_total;
  return {pose, active, active + row.passive / largest_total};
}

std::string winning_reason(const std::vector<CandidateRow>& rows) {
  if (rows.empty()) return "No candidate";
  const auto winner = std::find_if(rows.begin(), rows.end(), [](const auto& row) { return row.selected; });
  if (winner == rows.end()) return "No candidate was selected";
  if (rows.size() == 1) return "The only candidate";
  if (winner != rows.begin())
    return "Not the cheapest: " + figure(winner->total - rows.front().total) + " above it";
  const CandidateRow& second = *std::next(winner);
  const std::array<double, 3> gains = {second.pose - winner->pose, second.active - winner->active,
                                       second.passive - winner->passive};
  const auto largest = std::max_element(gains.begin(), gains.end());
  if (*largest <= 0 || second.total - winner->total < 5e-5) return "A tie with the second";
  static constexpr std::array<const char*, 3> terms = {
      "nearer to the user's pose", "less temporal cost of the leader", "less temporal cost of the follower"};
  return "Winner by " + figure(second.total - winner->total) + " — " +
         terms[static_cast<std::size_t>(std::distance(gains.begin(), largest))];
}

}  // namespace abrazo::widgets
