#pragma once

#include <optional>
#include <string>

#include "core/selection/meant_pairs.hpp"
#include "core/selection/vetoes.hpp"

namespace abrazo {

/// "I mean this move": what a person means when the choice is ambiguous (paper 5). By Eq. 7 only pairs
/// with this label, or of this take, are selected while there are any among those allowed; to the selection
/// `intent` it is evidence, and other pairs cost `meant-weight` more.
struct MeantMove {
  std::optional<std::string> label;
  std::optional<std::string> take;
  double until_s = -1;      ///< session clock; negative = until it is taken back
  bool until_done = false;  ///< also until a recorded move that was followed came to its end
  bool operator==(const MeantMove&) const = default;
};

inline std::optional<MeantPairs> pairs_of(const std::optional<MeantMove>& move) {
  return move ? std::optional(MeantPairs{move->label, move->take}) : std::nullopt;
}

/// What decides the user's role.
enum class RoleControl {
  Hand,     ///< the setting `user-role`
  Library,  ///< the annotated role intervals of the recorded pair that is followed
  Leader,   ///< who leads, seen in the motion: see role_switch.hpp for the rule
};

/// What a person asked of the selection beside the settings, as one value; kept with every frame.
struct Decisions {
  std::optional<int> pinned;
  Vetoes vetoes;
  std::optional<MeantMove> meant;
  RoleControl role_control = RoleControl::Hand;
  bool operator==(const Decisions&) const = default;
};

}  // namespace abrazo
