#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/session/frames/frame_snapshot.hpp"
#include "widgets/candidates/cost_terms.hpp"

namespace abrazo::widgets {

/// One candidate as a row of the table: its cost by the deciding method, in terms that add up.
struct CandidateRow {
  int candidate = -1;  ///< index into FrameResult::candidates
  int pair = -1;
  int rank = 0;        ///< 1 = cheapest
  int take_index = 0;  ///< index in the library
  std::string take;
  int frame = 0;
  bool swapped = false;
  std::string label;
  SelectionMethod method = SelectionMethod::Paper;
  std::array<double, most_cost_terms> terms{};  ///< weighted, in the order of cost_terms(method)
  double total = 0;                             ///< [m^2] by Eq. 7, [m] of `intent`
  double equation_7 = 0;                        ///< total of Eq. 7, even if it does not decide [m^2]
  double feature_distance = 0;                  ///< [m]
  bool selected = false;
  bool continues_source = false;  ///< continues the source of the previous frame; only with `intent`
  bool pinned = false;
  bool vetoed = false;     ///< by itself, its take or its label
  bool not_meant = false;  ///< another move is intended

  /// Whether it cannot be selected. Eq. 7 compares only pairs of the intended move; with `intent` the others
  /// cost more.
  bool is_out() const { return vetoed || (not_meant && method == SelectionMethod::Paper); }
};

/// Cheapest first; ties keep the order of their feature distance.
std::vector<CandidateRow> candidate_rows(const FrameSnapshot& frame, const MotionLibrary& library);

/// The value of a term; 0 if the row's method does not have it.
double value_of(const CandidateRow& row, CostTerm term);

/// Ends of the segments of a bar, in [0, 1] of the width of `largest_total`. Every part that there is has
/// `least` of the width and its share of the rest, so that it is seen however small.
/// @param least  at most 1 / most_cost_terms
std::array<double, most_cost_terms> bar_ends(const CandidateRow& row, double largest_total, double least);

}  // namespace abrazo::widgets
