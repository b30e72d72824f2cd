#pragma once

#include <string>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/session/frames/decisions.hpp"

namespace abrazo {

/// Nothing is pinned, vetoed or meant; who decides about the role is another matter.
bool is_neutral(const Decisions& decisions);

/// What a decision is about: the pair itself, all of its take, all with its label.
enum class Reach { Pair, Take, Label };

/// Pins a pair, which lifts the veto of that pair, or lets it go when it is the pinned one.
Decisions with_pin_toggled(Decisions decisions, int pair);

/// Vetoes, or lifts the veto that is there. A veto that covers the pinned pair lets it go, because a pin is
/// stronger than a veto.
Decisions with_veto_toggled(Decisions decisions, Reach reach, int pair, const MotionLibrary& library);
/// The same of a take by name.
Decisions with_take_toggled(Decisions decisions, const std::string& take, const MotionLibrary& library);

bool is_vetoed(const Decisions& decisions, Reach reach, int pair, const MotionLibrary& library);
/// By itself, its take or its label.
bool is_vetoed(const Decisions& decisions, int pair, const MotionLibrary& library);

/// Another move than the one that is meant.
bool is_not_meant(const Decisions& decisions, int pair, const MotionLibrary& library);
/// "turn", "take salsa_02", "without a label".
std::string meant_words(const MeantMove& move);

/// A decision in force, in words, and what is left without it.
struct Decision {
  enum class Kind { Veto, Pin, Meant };
  Kind kind = Kind::Veto;
  std::string text;  ///< "salsa_06 1342", "take salsa_02", "all turn", "7 pairs"
  Decisions without;
};

/// What is meant and the pin first, then labels, takes and pairs; more than three pairs are one decision.
std::vector<Decision> decisions_in_force(const Decisions& decisions, const MotionLibrary& library);

/// What of the decisions on one library means something in another: those on pairs, takes and labels that it
/// does not have fall away, pairs are numbered as there.
Decisions carried_over(const Decisions& decisions, const MotionLibrary& from, const MotionLibrary& to);

/// "salsa_06 1342"
std::string pair_name(int pair, const MotionLibrary& library);

}  // namespace abrazo
