#include "widgets/candidates/winning_reason.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>

namespace abrazo::widgets {
namespace {

constexpr double least_shown = 5e-5;  ///< smaller differences are ignored

/// As the rows show it.
std::string figure(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f", value);
  return text.data();
}

/// The largest advantage of a row over another in one term.
struct Gain {
  const CostTermInfo* term;
  double value;
};

/// @param with_change  whether the margin counts, which concerns the source and not the user
Gain largest_gain(const CandidateRow& row, const CandidateRow& other, bool with_change = false) {
  Gain largest{nullptr, 0};
  for (const CostTermInfo& info : cost_terms(row.method).terms) {
    const double gain = value_of(other, info.term) - value_of(row, info.term);
    if ((with_change || info.term != CostTerm::Change) && gain > largest.value) largest = {&info, gain};
  }
  return largest;
}

std::string because(const Gain& gain) {
  return gain.term ? " — " + std::string(gain.term->gain) : std::string();
}

std::string amount(double value, SelectionMethod method) {
  return figure(value) + " " + std::string(cost_terms(method).unit);
}

/// "0.024 m", by which the second costs more: the difference of the totals as the rows show them, so that a
/// person who subtracts these finds the same.
std::string dearer_by(const CandidateRow& first, const CandidateRow& second) {
  const double thousandths = std::round(1000 * second.total) - std::round(1000 * first.total);
  if (thousandths <= 0) return "less than " + amount(0.001, first.method);
  return amount(thousandths / 1000, first.method);
}

std::string paper_reason(const CandidateRow& winner, const CandidateRow& second) {
  const Gain gain = largest_gain(winner, second);
  if (!gain.term || second.total - winner.total < least_shown) return "A tie with the second";
  return "Winner by " + dearer_by(winner, second) + because(gain);
}

/// Of a winner that continues its source: others pay for the change, and are compared with what they pay.
std::string continuation(const CandidateRow& winner, const CandidateRow& second) {
  const double more = second.total - winner.total;
  if (more < least_shown) return "Continues: #2 costs as much";
  const std::string difference = dearer_by(winner, second);
  const std::string words = "Continues: #2 costs " + difference + " more";
  const Gain part = largest_gain(winner, second, true);
  const bool is_change = part.term && part.term->term == CostTerm::Change;
  if (!is_change && !(part.term && part.term->term == CostTerm::Temporal)) return words + because(part);
  const std::string paid = amount(part.value, winner.method);
  const std::string what = is_change ? "for the change" : "for leaving the shown partner";
  if (paid == difference || std::abs(part.value - more) < least_shown) return words + ", all of it " + what;
  return words + (part.value > more ? ", because of the " + paid + " " : ", " + paid + " of it ") + what;
}

std::string change(const CandidateRow& winner, const CandidateRow& continuation) {
  if (continuation.is_out()) return "Change: continuing is vetoed";
  return "Change: continuing (#" + std::to_string(continuation.rank) + ") costs " +
         dearer_by(winner, continuation) + " more" + because(largest_gain(winner, continuation));
}

std::string intent_reason(const std::vector<CandidateRow>& rows, const FrameIntent& intent) {
  const CandidateRow& winner = rows.front();
  const CandidateRow& second = rows[1];
  if (winner.continues_source) return continuation(winner, second);
  const auto other = std::ranges::find_if(rows, &CandidateRow::continues_source);
  if (other != rows.end()) return change(winner, *other);
  // Only a frame solved here has the information that there was no continuation.
  const std::string before = intent.model && intent.continued < 0 ? "No source to continue. " : "";
  const double margin = second.total - winner.total;
  if (margin < least_shown) return before + "A tie with #2";
  return before + "#2 costs " + dearer_by(winner, second) + " more" + because(largest_gain(winner, second));
}

std::string move_name(std::string label) {
  if (label.empty()) return "no label";
  std::ranges::replace(label, '_', ' ');
  return label;
}

}  // namespace

std::string winning_reason(const std::vector<CandidateRow>& rows, const FrameIntent& intent) {
  if (rows.empty()) return "No candidate";
  const auto winner = std::ranges::find_if(rows, &CandidateRow::selected);
  if (winner == rows.end()) return "No candidate was selected";
  if (rows.size() == 1) return "The only candidate";
  const bool is_by_intent = winner->method == SelectionMethod::Intent;
  if (winner != rows.begin()) {
    const std::string why = winner->pinned           ? "Pinned by you"
                            : rows.front().vetoed    ? "#1 is vetoed by you"
                            : rows.front().not_meant ? "#1 is not the intended move"
                                                     : "Not the cheapest";
    return why + ": #1 costs " + dearer_by(rows.front(), *winner) + " less";
  }
  return is_by_intent ? intent_reason(rows, intent) : paper_reason(rows[0], rows[1]);
}

std::string likely_moves(std::span<const std::string> labels, std::span<const float> moves) {
  constexpr float also_likely = 0.1F;
  if (labels.size() != moves.size() || labels.empty()) return {};
  if (labels.size() == 1 && labels.front().empty()) return {};
  std::vector<std::size_t> order(labels.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const std::size_t most = std::min<std::size_t>(2, order.size());
  std::ranges::partial_sort(order, order.begin() + static_cast<std::ptrdiff_t>(most), std::greater<>(),
                            [&](std::size_t i) { return moves[i]; });
  std::string words;
  for (std::size_t i = 0; i < most; ++i) {
    const float likely = moves[order[i]];
    if (i > 0 && likely < also_likely) break;
    std::array<char, 16> percent{};
    std::snprintf(percent.data(), percent.size(), " %.0f %%", 100.0 * static_cast<double>(likely));
    words += (i == 0 ? "Likely move: " : ", ") + move_name(labels[order[i]]) + percent.data();
  }
  return words;
}

}  // namespace abrazo::widgets
