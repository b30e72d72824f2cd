#include "widgets/annotation/suggestion_rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace abrazo::widgets {
namespace {

/// "1:02.35"
std::string clock(double seconds) {
  const int minutes = static_cast<int>(seconds / 60);
  char text[32];
  std::snprintf(text, sizeof text, "%d:%05.2f", minutes, seconds - 60 * minutes);
  return text;
}

}  // namespace

std::vector<SuggestionRow> suggestion_rows(const Annotations& annotations) {
  std::vector<SuggestionRow> rows;
  for (const Suggestion& one : annotations.suggestions()) {
    const AnnotationTier* tier = annotations.tier(one.tier);
    rows.push_back({one.id, one.tier, one.start_s, one.end_s, one.confidence, tier ? tier->name : "",
                    one.value, one.reason});
  }
  std::stable_sort(rows.begin(), rows.end(), [](const SuggestionRow& a, const SuggestionRow& b) {
    return a.confidence != b.confidence ? a.confidence > b.confidence : a.start_s < b.start_s;
  });
  return rows;
}

int row_of(const std::vector<SuggestionRow>& rows, int id) {
  const auto found =
      std::find_if(rows.begin(), rows.end(), [id](const SuggestionRow& row) { return row.id == id; });
  return found == rows.end() ? -1 : static_cast<int>(found - rows.begin());
}

std::vector<int> at_least(const std::vector<SuggestionRow>& rows, double confidence) {
  std::vector<SuggestionRow> sure;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(sure),
               [confidence](const SuggestionRow& row) { return row.confidence >= confidence; });
  std::stable_sort(sure.begin(), sure.end(),
                   [](const SuggestionRow& a, const SuggestionRow& b) { return a.start_s < b.start_s; });
  std::vector<int> ids;
  for (const SuggestionRow& row : sure) ids.push_back(row.id);
  return ids;
}

std::string words_of(const SuggestionRow& row) {
  return clock(row.start_s) + " – " + clock(row.end_s) + "   " + row.value + "   " +
         std::to_string(std::lround(100 * row.confidence)) + " %";
}

}  // namespace abrazo::widgets
