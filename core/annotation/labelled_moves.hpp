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
  int active = -1;  ///< 0 = a, 1 = b, -1 = unknown
};

/// A take, or a piece of one, for comparison.
struct LabelledTake {
  int take = 0;                            ///< of the library
  std::array<MotionChannels, 2> channels;  ///< a active, b active
  std::vector<LabelledMove> moves;         ///< ascending
};

/// Labelled moves and roles of the takes of a library.
struct LabelledMoves {
  std::vector<std::string> labels;
  std::vector<LabelledTake> takes;
  bool has_labels = false;  ///< otherwise every stretch of one role is a "move" with the label ""
  bool has_roles = false;
  int move_count = 0;
};

/// Sampling rate of the quantities [Hz].
inline constexpr double suggestion_rate_hz = 30;

/// From all takes except one. A small number of takes is cut into pieces at moves, so that some can be used
/// for testing.
/// @param without  index of a take; -1 = none
LabelledMoves labelled_moves(const MotionLibrary& library, int without);

/// Channels of a take in both orders.
std::array<MotionChannels, 2> channels_of(const CoupleMotion& motion);

}  // namespace abrazo
