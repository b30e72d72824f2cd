#pragma once

#include <memory>
#include <optional>

#include "core/selection/intended_pairs.hpp"
#include "core/selection/vetoes.hpp"
#include "core/synthesis/settings/settings.hpp"
#include "core/synthesis/step/frame_memory.hpp"

namespace abrazo {

/// State of a PartnerSynthesizer between two frames. Another one over the same library continues from it with
/// identical bits.
struct SynthesizerState {
  UserRole user_role = UserRole::Active;
  FrameMemory memory;             ///< in the order of bodies that the user's role gives: user, partner
  std::optional<Body> user_body;  ///< as given; none if it is measured
  std::optional<int> pinned;
  std::shared_ptr<const Vetoes> vetoes;  ///< shared by the states between two changes; never null
  std::optional<IntendedPairs> meant;
  double unsolved_s = 0;  ///< since the last solved frame
};

}  // namespace abrazo
