#pragma once

#include <vector>

#include "core/annotation/labelled_moves.hpp"

namespace abrazo {

/// How often labels follow one another in labelled takes, and how often the active performer changes between
/// two moves, as log probabilities. Counts are smoothed towards how frequent the labels are. A state is
/// label * roles + active.
struct LabelOrder {
  int states = 0;
  std::vector<double> follows;      ///< states x states, from row to column
  std::vector<double> first, last;  ///< by state
};
/// @param roles  2 when either performer may be active, else 1
LabelOrder label_order(const LabelledMoves& moves, int roles);

}  // namespace abrazo
