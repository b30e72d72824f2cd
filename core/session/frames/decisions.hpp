#pragma once

#include <optional>
#include <string>

#include "core/selection/intended_pairs.hpp"
#include "core/selection/vetoes.hpp"

namespace abrazo {

/// The intended move: what the user declares when the selection is ambiguous (paper 5). Eq. 7 then selects
/// only pairs with this label, or of this take, as long as any are allowed; for the selection `intent` it is
/// evidence, and other pairs cost `meant-weight` more.
struct IntendedMove {
  std::optional<std::string> label;
  std::optional<std::string> take;
  double until_s = -1;      ///< session clock; negative = until cancelled
  bool until_done = false;  ///< also ends when a recorded move that was followed ends
  bool operator==(const IntendedMove&) const = default;
};

inline std::optional<IntendedPairs> pairs_of(const std::optional<IntendedMove>& move) {
  return move ? std::optional(IntendedPairs{move->label, move->take}) : std::nullopt;
}

/// What decides the user's role.
enum class RoleControl {
  Hand,     ///< the setting `user-role`
  Library,  ///< annotated role intervals of the recorded pair that is followed
  Leader,   ///< who leads, judged from the motion; the rule is in role_switch.hpp
};

/// A person's choices for the selection beside the settings, as one value; kept with every frame.
struct Decisions {
  std::optional<int> pinned;
  Vetoes vetoes;
  std::optional<IntendedMove> meant;
  RoleControl role_control = RoleControl::Hand;
  bool operator==(const Decisions&) const = default;
};

}  // namespace abrazo
