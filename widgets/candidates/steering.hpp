#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/session/frames/command.hpp"

namespace abrazo::widgets {

/// What a person decided about the selection, as one value; it acts from the solver's next step on.
struct Steering {
  std::optional<int> pinned;  ///< the pair that is selected, whatever it costs
  Vetoes vetoes;
  std::optional<MeantMove> meant;  ///< only these are selected, while there are any

  bool empty() const { return !pinned && vetoes.empty() && !meant; }
  bool operator==(const Steering&) const = default;
};

/// What a decision is about: the pair itself, all of its take, all with its label.
enum class Reach { Pair, Take, Label };

/// Pins a pair, which lifts the veto of that pair, or lets it go when it is the pinned one.
Steering with_pin_toggled(Steering steering, int pair);

/// Vetoes, or lifts the veto that is there. A veto that covers the pinned pair lets it go, because a pin is
/// stronger than a veto.
Steering with_veto_toggled(Steering steering, Reach reach, int pair, const MotionLibrary& library);

bool is_vetoed(const Steering& steering, Reach reach, int pair, const MotionLibrary& library);
/// By itself, its take or its label.
bool is_vetoed(const Steering& steering, int pair, const MotionLibrary& library);

/// Another move than the one that is meant.
bool is_not_meant(const Steering& steering, int pair, const MotionLibrary& library);
/// "turn", "take salsa_02", "without a label".
std::string meant_words(const MeantMove& move);

/// A decision in force, in words, and what is left without it.
struct Decision {
  enum class Kind { Veto, Pin, Meant };
  Kind kind = Kind::Veto;
  std::string text;  ///< "salsa_06 1342", "take salsa_02", "all turn", "7 pairs"
  Steering without;
};

/// What is meant and the pin first, then labels, takes and pairs; more than three pairs are one decision.
std::vector<Decision> decisions_in_force(const Steering& steering, const MotionLibrary& library);

/// "salsa_06 1342"
std::string pair_name(int pair, const MotionLibrary& library);

}  // namespace abrazo::widgets
