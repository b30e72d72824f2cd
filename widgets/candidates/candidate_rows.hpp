#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/session/frames/frame_snapshot.hpp"
#include "widgets/candidates/cost_terms.hpp"

namespace abrazo::widgets {

/// One candidate as the table shows it: what it costs by the method that decided, in parts that add up.
struct CandidateRow {
  int candidate = -1;  ///< index into FrameResult::candidates
  int pair = -1;
  int rank = 0;        ///< 1 = cheapest
  int take_index = 0;  ///< in the library
  std::string take;
  int frame = 0;
  bool swapped = false;
  std::string label;
  SelectionMethod method = SelectionMethod::Paper;
  std::array<double, most_cost_terms> terms{};  ///< weighed, in the order of cost_terms(method)
  double total = 0;                             ///< [m^2] by Eq. 7, [m] of `intent`
  double equation_7 = 0;                        ///< its total, also where it does not decide [m^2]
  double feature_distance = 0;                  ///< [m]
  bool selected = false;
  bool goes_on = false;  ///< continues the source of the frame before; only told with `intent`
  bool pinned = false;
  bool vetoed = false;     ///< by itself, its take or its label
  bool not_meant = false;  ///< another move is meant

  /// Cannot be selected. Eq. 7 compares only what is meant; with `intent` the others cost more.
  bool is_out() const { return vetoed || (not_meant && method == SelectionMethod::Paper); }
};

/// Cheapest first; ties keep the order of their feature distance.
std::vector<CandidateRow> candidate_rows(const FrameSnapshot& frame, const MotionLibrary& library);

/// The value of a term; 0 when the row's method does not have it.
double value_of(const CandidateRow& row, CostTerm term);

/// Where the parts of a bar end, in [0, 1] of the width that `largest_total` takes.
std::array<double, most_cost_terms> bar_ends(const CandidateRow& row, double largest_total);

}  // namespace abrazo::widgets
