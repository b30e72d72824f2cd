#pragma once

#include <string>
#include <vector>

#include "core/library/motion_library.hpp"
#include "core/session/frame_snapshot.hpp"

namespace abrazo::widgets {

/// One candidate as the table shows it: the cost of Eq. 7 as three parts that add up to the total [m^2].
struct CandidateRow {
  int candidate = -1;  ///< index into FrameResult::candidates
  int pair = -1;
  int rank = 0;        ///< 1 = cheapest
  int take_index = 0;  ///< in the library
  std::string take;
  int frame = 0;
  bool swapped = false;
  std::string label;
  double pose = 0;
  double active = 0;   ///< alpha times the temporal cost of the active character
  double passive = 0;  ///< alpha times that of the passive character
  double total = 0;
  double feature_distance = 0;  ///< [m]
  bool selected = false;
  bool pinned = false;
  bool vetoed = false;     ///< by itself, its take or its label
  bool not_meant = false;  ///< another move is meant
};

/// Cheapest first; ties keep the order of their feature distance.
std::vector<CandidateRow> candidate_rows(const FrameSnapshot& frame, const MotionLibrary& library);

/// Where the parts of a bar end, in [0, 1] of the width that `largest_total` takes.
struct BarEnds {
  double pose, active, passive;
};
BarEnds bar_ends(const CandidateRow& row, double largest_total);

/// Of the cheapest-first order. "Winner by 0.024 — less temporal cost of the follower": the margin to the
/// runner-up and the term that decided it. Says so when the winner is not the cheapest (a pinned pair), or
/// when there is nothing to compare with.
std::string winning_reason(const std::vector<CandidateRow>& rows);

}  // namespace abrazo::widgets
