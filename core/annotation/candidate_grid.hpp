#pragma once

#include <algorithm>

#include "core/annotation/labelled_moves.hpp"

namespace abrazo {

/// Candidate stretches for moves: those between two points of a regular grid with lengths similar to labelled
/// moves.
struct CandidateGrid {
  int cell = 1;      ///< frames between two possible cuts
  int cells = 1;     ///< of the take
  int shortest = 1;  ///< of a candidate [cells]
  int longest = 1;
  int frames = 0;

  int begin(int at) const { return at * cell; }
  int end(int at, int length) const { return std::min(frames, (at + length) * cell); }
};

/// Range of lengths of labelled moves, with a margin [s].
struct CandidateLengths {
  double shortest_s = 1, longest_s = 2;
};
CandidateLengths candidate_lengths(const LabelledMoves& moves);
CandidateGrid candidate_grid(const MotionChannels& channels, const CandidateLengths& lengths);

/// Intersection over union of two stretches.
double overlap(int begin, int end, int other_begin, int other_end);

}  // namespace abrazo
