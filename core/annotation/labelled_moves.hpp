#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/annotation/motion_channels.hpp"
#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// A labelled stretch of a take, in frames of its CoupleMotion.
struct LabelledMove {
  int begin = 0, end = 0;
  int label = 0;    ///< index into LabelledMoves::labels
  int active = -1;  ///< 0 = a, 1 = b, -1 = not known
};

/// A take, or a piece of one, that others can be compared with.
struct LabelledTake {
  int take = 0;                            ///< of the library
  std::array<MotionChannels, 2> channels;  ///< a active, b active
  std::vector<LabelledMove> moves;         ///< ascending
};

/// What the takes of a library say of moves and roles.
struct LabelledMoves {
  std::vector<std::string> labels;
  std::vector<LabelledTake> takes;
  bool has_labels = false;  ///< else every stretch of one role is a "move" with the label ""
  bool has_roles = false;
  int move_count = 0;
};

/// Quantities are looked at this often [Hz].
inline constexpr double suggestion_rate_hz = 30;

/// Of all takes but one. Few takes are cut into pieces at moves, so that there are some to test with.
/// @param without  index of a take; -1 = none
LabelledMoves labelled_moves(const MotionLibrary& library, int without);

/// Channels of a take in both orders.
std::array<MotionChannels, 2> channels_of(const CoupleMotion& motion);

}  // namespace abrazo
