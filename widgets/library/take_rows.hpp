#pragma once

#include <string>
#include <vector>

#include "core/library/store/motion_library.hpp"

namespace abrazo::widgets {

/// A take as a row of the list. Positions along the take are fractions of its length [0, 1].
struct TakeRow {
  int take = -1;
  std::string name;
  int frames = 0;
  double fps = 60;
  double seconds = 0;

  struct Move {
    double from = 0, to = 0;
    std::string label;
  };
  std::vector<Move> moves;

  struct Role {
    double from = 0, to = 0;
    ActivePerformer active = ActivePerformer::Unknown;
  };
  std::vector<Role> roles;          ///< over the whole length, including unannotated parts
  std::string leader;               ///< "A leads", "A leads 60 %", "either leads"
  std::vector<std::string> labels;  ///< of the take, each once
};

std::vector<TakeRow> take_rows(const MotionLibrary& library);

/// Whether every word of a filter is in the take's name or one of its labels; ignores letter case, "_" counts
/// as a blank.
bool matches(const TakeRow& row, const std::string& filter);

/// Look-up table of the pair for a frame of a take; built once, because the list queries it at every pointer
/// move.
class PairsOfTakes {
 public:
  PairsOfTakes() = default;
  explicit PairsOfTakes(const MotionLibrary& library);

  /// The pair of the nearest frame in the library (thinned takes skip some), with performer A active if both
  /// exist. @return -1 if the take has no pair
  int pair_at(int take, int frame) const;

 private:
  struct Take {
    int stride = 1;
    std::vector<int> pairs;  ///< per kept frame; -1 = none
  };
  std::vector<Take> takes_;
};

}  // namespace abrazo::widgets
