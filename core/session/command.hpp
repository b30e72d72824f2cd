#pragma once

#include <optional>
#include <variant>

#include "core/selection/vetoes.hpp"
#include "core/synthesis/settings.hpp"

namespace abrazo {

/// All a view may ask of the running solver. Applied in order, between two frames.
struct SetSettings {
  Settings settings;
};
struct PinPair {
  std::optional<int> pair;
};
/// All of them, in place of those before.
struct SetVetoes {
  Vetoes vetoes;
};
struct ResetSolver {};
struct PauseInput {
  bool paused = true;
};  ///< the clip that stands in for the user holds still
struct SeekInput {
  double time_s = 0;
};  ///< of the clip
struct SetInputSpeed {
  double factor = 1;
};
using Command =
    std::variant<SetSettings, PinPair, SetVetoes, ResetSolver, PauseInput, SeekInput, SetInputSpeed>;

}  // namespace abrazo
