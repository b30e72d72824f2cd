#pragma once

#include <string>
#include <vector>

#include "core/annotation/annotations.hpp"

namespace abrazo::widgets {

/// A suggestion as a row of a list.
struct SuggestionRow {
  int id = 0, tier = 0;
  double start_s = 0, end_s = 0, confidence = 0;
  std::string tier_name, value, reason;
};

/// Highest confidence first, then earliest.
std::vector<SuggestionRow> suggestion_rows(const Annotations& annotations);

/// Row of a suggestion; -1 if it is not listed.
int row_of(const std::vector<SuggestionRow>& rows, int id);

/// Ids of those with at least this confidence, in order of time.
std::vector<int> at_least(const std::vector<SuggestionRow>& rows, double confidence);

/// "0:12.3 – 0:15.0  turn  87 %"
std::string words_of(const SuggestionRow& row);

}  // namespace abrazo::widgets
