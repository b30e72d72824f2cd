#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/session/frames/decisions.hpp"

namespace abrazo::widgets {

/// A move, or a take, that the user may intend, and how near the user is to the nearest recorded pair of it.
struct IntendedMoveChoice {
  std::string label;       ///< of a move; "" = pairs without one
  std::string take;        ///< not empty: it is a take
  int pairs = 0;           ///< that may be selected
  double distance_m = -1;  ///< in feature space; negative when there is no frame

  bool is_take() const { return !take.empty(); }
  bool operator==(const IntendedMoveChoice&) const = default;
};

/// How long it holds.
enum class IntendedMoveSpan { UntilTakenBack, UntilDone, FiveSeconds, TenSeconds };

/// What the solver is given. @param now_s  session clock
MeantMove meant_move(const IntendedMoveChoice& choice, IntendedMoveSpan span, double now_s);

/// "turn", "take salsa_02", "no label".
std::string choice_title(const IntendedMoveChoice& choice);
/// "0.12 m", with enough decimals to tell neighbours apart; empty without a frame.
std::string distance_text(double distance_m);
/// Moves before takes, each the nearest first, those of unknown distance last and as they come.
std::vector<IntendedMoveChoice> in_order(std::vector<IntendedMoveChoice> choices);
/// The choice of a digit key, 1 for the first; nothing when there is none.
std::optional<std::size_t> choice_of_digit(int digit, std::size_t choices);

}  // namespace abrazo::widgets
