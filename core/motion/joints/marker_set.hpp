#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/motion/joints/marker_model.hpp"

namespace abrazo {

/// The points of a file that are markers of a model. Matching ignores letter case, separators ("r asis",
/// "R.ASIS", "R_Asis"), a subject before ':' and a prefix that all names share.
class MarkerSet {
 public:
  MarkerSet(const MarkerModel& model, std::vector<std::string> points);
  bool has(MarkerPlace place, std::size_t side = 0) const { return of(place, side) >= 0; }
  bool has_both(MarkerPlace place) const { return has(place, 0) && has(place, 1); }
  /// Index of the point; -1: none
  int of(MarkerPlace place, std::size_t side) const { return points_[static_cast<std::size_t>(place)][side]; }
  /// All points that are markers of the model.
  std::vector<int> all() const;

 private:
  std::array<std::array<int, 2>, marker_place_count> points_{};
};

}  // namespace abrazo
