#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/session/frames/decisions.hpp"

namespace abrazo::widgets {

/// A move or take that the user may intend, with the distance to its nearest recorded pair.
struct IntendedMoveChoice {
  std::string label;       ///< of a move; "" = pairs without a label
  std::string take;        ///< not empty for a take
  int pairs = 0;           ///< number of selectable pairs
  double distance_m = -1;  ///< in feature space; negative without a frame

  bool is_take() const { return !take.empty(); }
  bool operator==(const IntendedMoveChoice&) const = default;
};

/// Duration of an intended move.
enum class IntendedMoveSpan { UntilTakenBack, UntilDone, FiveSeconds, TenSeconds };

/// The command for the solver. @param now_s session clock
IntendedMove meant_move(const IntendedMoveChoice& choice, IntendedMoveSpan span, double now_s);

/// "turn", "take salsa_02", "no label".
std::string choice_title(const IntendedMoveChoice& choice);
/// "0.12 m", with enough decimals to distinguish neighbours; empty without a frame.
std::string distance_text(double distance_m);
/// Moves before takes, nearest first; unknown distances last, in the given order.
std::vector<IntendedMoveChoice> in_order(std::vector<IntendedMoveChoice> choices);
/// The choice of a digit key, 1 for the first; none if there is none.
std::optional<std::size_t> choice_of_digit(int digit, std::size_t choices);

}  // namespace abrazo::widgets
