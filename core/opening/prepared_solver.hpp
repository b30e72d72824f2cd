#pragma once

#include <memory>

#include "core/opening/material.hpp"
#include "core/synthesis/step/partner_synthesizer.hpp"

namespace abrazo {

/// A solver ready to run; prepared on a worker because the index over the library takes time.
struct PreparedSolver {
  Material material;
  std::unique_ptr<PartnerSynthesizer> synthesizer;
};

/// @return an Error if the input has no frames and nothing was recorded, or the settings do not suit the
/// library
Result<PreparedSolver> prepare_solver(Material material, const Settings& settings);

}  // namespace abrazo
