#pragma once

#include <string>
#include <vector>

#include "core/annotation/annotations.hpp"

namespace abrazo::widgets {

/// A suggestion as a list shows it.
struct SuggestionRow {
  int id = 0, tier = 0;
  double start_s = 0, end_s = 0, confidence = 0;
  std::string tier_name, value, reason;
};

/// The surest first, of equals the earliest.
std::vector<SuggestionRow> suggestion_rows(const Annotations& annotations);

/// Where a suggestion stands; -1 when it is not there.
int row_of(const std::vector<SuggestionRow>& rows, int id);

/// Ids of those that are at least as sure, in order of time.
std::vector<int> at_least(const std::vector<SuggestionRow>& rows, double confidence);

/// "0:12.3 – 0:15.0  turn  87 %"
std::string words_of(const SuggestionRow& row);

}  // namespace abrazo::widgets
