#pragma once

#include <vector>

#include "core/annotation/labelled_moves.hpp"

namespace abrazo {

/// Log probabilities of successive labels in labelled takes, and of a change of the active performer between
/// two moves. Counts are smoothed towards the frequency of the labels. A state is label * roles + active.
struct LabelOrder {
  int states = 0;
  std::vector<double> follows;      ///< states x states, from row to column
  std::vector<double> first, last;  ///< by state
};
/// @param roles 2 if either performer may be active, else 1
LabelOrder label_order(const LabelledMoves& moves, int roles);

}  // namespace abrazo
