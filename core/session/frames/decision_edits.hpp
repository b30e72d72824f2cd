#pragma once

#include <string>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/session/frames/decisions.hpp"

namespace abrazo {

/// Nothing is pinned, vetoed or intended. Role control does not count.
bool is_neutral(const Decisions& decisions);

/// Scope of a decision: the pair, all of its take, or all with its label.
enum class Reach { Pair, Take, Label };

/// Pins a pair and lifts its veto; unpins it if it is pinned.
Decisions with_pin_toggled(Decisions decisions, int pair);

/// Adds a veto, or lifts an existing one. A veto that covers the pinned pair unpins it, because a pin
/// overrides vetoes.
Decisions with_veto_toggled(Decisions decisions, Reach reach, int pair, const MotionLibrary& library);
/// The same for a take by name.
Decisions with_take_toggled(Decisions decisions, const std::string& take, const MotionLibrary& library);

bool is_vetoed(const Decisions& decisions, Reach reach, int pair, const MotionLibrary& library);
/// Vetoed itself, or by its take or label.
bool is_vetoed(const Decisions& decisions, int pair, const MotionLibrary& library);

/// Whether a move is intended and the pair belongs to another.
bool is_not_intended(const Decisions& decisions, int pair, const MotionLibrary& library);
/// "turn", "take salsa_02", "without a label".
std::string meant_words(const IntendedMove& move);

/// A decision in force as text, and the decisions without it.
struct Decision {
  enum class Kind { Veto, Pin, Meant };
  Kind kind = Kind::Veto;
  std::string text;  ///< "salsa_06 1342", "take salsa_02", "all turn", "7 pairs"
  Decisions without;
};

/// Intended move and pin first, then labels, takes and pairs; more than three pairs are listed as one
/// decision.
std::vector<Decision> decisions_in_force(const Decisions& decisions, const MotionLibrary& library);

/// Decisions on one library translated to another: those on pairs, takes and labels that are not in it are
/// dropped, pair numbers are converted.
Decisions carried_over(const Decisions& decisions, const MotionLibrary& from, const MotionLibrary& to);

/// "salsa_06 1342"
std::string pair_name(int pair, const MotionLibrary& library);

}  // namespace abrazo
