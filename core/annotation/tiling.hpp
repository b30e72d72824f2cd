#pragma once

#include <cstddef>
#include <vector>

namespace abrazo {

/// Scores, as log odds, of the ways to cut a row of cells into segments with one state each.
class TilingScores {
 public:
  /// @param cells     at least 1
  /// @param longest   cells of the longest segment
  TilingScores(int cells, int longest, int states);

  int cells() const { return cells_; }
  int longest() const { return longest_; }
  int states() const { return states_; }

  /// Score of the segment [begin, begin + length) in a state; initially 0.
  double& segment(int begin, int length, int state) { return segments_[index(begin, length, state)]; }
  double segment(int begin, int length, int state) const { return segments_[index(begin, length, state)]; }
  /// Score of a segment that follows one in another state.
  double& follows(int before, int state) {
    return follows_[static_cast<std::size_t>(before * states_ + state)];
  }
  double follows(int before, int state) const {
    return follows_[static_cast<std::size_t>(before * states_ + state)];
  }
  std::vector<double> first, last;  ///< of the first and the last segment's state

 private:
  std::size_t index(int begin, int length, int state) const {
    return (static_cast<std::size_t>(begin) * static_cast<std::size_t>(longest_) +
            static_cast<std::size_t>(length - 1)) *
               static_cast<std::size_t>(states_) +
           static_cast<std::size_t>(state);
  }
  int cells_, longest_, states_;
  std::vector<double> segments_, follows_;
};

/// Cells [begin, end) in a state.
struct TilingSegment {
  int begin = 0, end = 0, state = 0;
  bool operator==(const TilingSegment&) const = default;
};

/// The tiling with the greatest sum, found by dynamic programming over the cuts (a segmental Viterbi search).
/// Empty if no tiling is possible (all scores are -infinity).
std::vector<TilingSegment> best_tiling(const TilingScores& scores);

/// Probability of each state in each cell, cells x states, if the probability of a tiling is proportional to
/// exp(score / temperature): forward-backward sums of a hidden semi-Markov model.
/// @param temperature above 0; higher values give less certain results
std::vector<double> state_probabilities(const TilingScores& scores, double temperature);

}  // namespace abrazo
