#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/evaluation/tables/evaluation.hpp"

// Figures of section 4 of Ho, Chan, Komura and Leung (2013), shown beside ours.

namespace abrazo::paper {

struct SelectionRow {
  int k;
  double recall_best, recall_best2, time_ms;
};
inline constexpr std::array<SelectionRow, 10> table_1 = {{{5, 0.9285, 0.9573, 13.8},
                                                          {10, 0.9507, 0.9773, 14.9},
                                                          {15, 0.9654, 0.9875, 15.8},
                                                          {20, 0.9787, 0.9898, 17.0},
                                                          {25, 0.9809, 0.9898, 18.0},
                                                          {30, 0.9875, 0.9920, 19.9},
                                                          {35, 0.9875, 0.9920, 21.5},
                                                          {40, 0.9875, 0.9920, 23.1},
                                                          {45, 0.9920, 0.9942, 24.9},
                                                          {50, 0.9920, 0.9942, 26.7}}};

struct TimingRow {
  int pairs;
  double knn_ms, brute_ms;
};
inline constexpr std::array<TimingRow, 3> table_2 = {
    {{7500, 12.4, 40.5}, {15000, 13.6, 77.0}, {30000, 15.0, 145.2}}};

struct MoveRow {
  std::string_view experiment;
  int total, successful;
};
inline constexpr std::array<MoveRow, 4> table_3 = {{{"salsa dance, leave one out (expert)", 27, 26},
                                                    {"salsa dance, user A (beginner)", 40, 34},
                                                    {"salsa dance, user B (beginner)", 31, 26},
                                                    {"fighting, leave one out (expert)", 26, 24}}};

struct ZmpRow {
  std::string_view motion;
  double original, synthesised;
};
inline constexpr std::array<ZmpRow, 2> table_4 = {{{"salsa dance", 0.70, 0.72}, {"fighting", 2.24, 2.21}}};

/// The row of Table I for k; null if it has none.
const SelectionRow* selection_row(int k);
/// The row of Table II for this number of pairs; null if it has none.
const TimingRow* timing_row(int pairs);

}  // namespace abrazo::paper

namespace abrazo {

/// The experiment of the paper that the moves resemble, by the names of their labels.
struct Style {
  bool dance = false, fight = false;
};
Style style_of(const Evaluation& evaluation);

/// 95 % interval of a counted share (Wilson's score interval).
struct ShareInterval {
  double low = 0, high = 1;
};
ShareInterval share_interval(int part, int total);

}  // namespace abrazo
