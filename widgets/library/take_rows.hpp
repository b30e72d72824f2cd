#pragma once

#include <string>
#include <vector>

#include "core/library/store/motion_library.hpp"

namespace abrazo::widgets {

/// What the list says of a take. Places along the take are fractions of its length [0, 1].
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
  std::vector<Role> roles;          ///< over the whole length, also where nothing was annotated
  std::string leader;               ///< "A leads", "A leads 60 %", "either leads"
  std::vector<std::string> labels;  ///< that it has, each once
};

std::vector<TakeRow> take_rows(const MotionLibrary& library);

/// Whether every word of a filter is in the take's name or one of its labels; letter case does not count, "_"
/// is a blank.
bool matches(const TakeRow& row, const std::string& filter);

/// Which pair shows a frame of a take; found once, because a list asks at every move of the pointer.
class PairsOfTakes {
 public:
  PairsOfTakes() = default;
  explicit PairsOfTakes(const MotionLibrary& library);

  /// The pair of the nearest frame that the library keeps (thinned takes skip some), with performer A active
  /// where there are both. @return -1 when the take has no pair
  int pair_at(int take, int frame) const;

 private:
  struct Take {
    int stride = 1;
    std::vector<int> pairs;  ///< per kept frame; -1 where there is none
  };
  std::vector<Take> takes_;
};

}  // namespace abrazo::widgets
