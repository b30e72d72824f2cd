#pragma once

#include <algorithm>

#include "core/annotation/labelled_moves.hpp"

namespace abrazo {

/// Which stretches of a take can be moves: those between two points of a regular grid, of lengths as the
/// labelled moves have them.
struct CandidateGrid {
  int cell = 1;      ///< frames between two possible cuts
  int cells = 1;     ///< of the take
  int shortest = 1;  ///< of a candidate [cells]
  int longest = 1;
  int frames = 0;

  int begin(int at) const { return at * cell; }
  int end(int at, int length) const { return std::min(frames, (at + length) * cell); }
};

/// Lengths of the labelled moves with some room on both sides [s].
struct CandidateLengths {
  double shortest_s = 1, longest_s = 2;
};
CandidateLengths candidate_lengths(const LabelledMoves& moves);
CandidateGrid candidate_grid(const MotionChannels& channels, const CandidateLengths& lengths);

/// Shared by two stretches, of what they cover together: intersection over union.
double overlap(int begin, int end, int other_begin, int other_end);

}  // namespace abrazo
