#include "core/opening/prepared_solver.hpp"

namespace abrazo {

Result<PreparedSolver> prepare_solver(Material material, const Settings& settings) {
  auto synthesizer = PartnerSynthesizer::create(material.library, settings, material.excluded_takes);
  if (!synthesizer) return synthesizer.error();
  if (material.input.poses.empty() && !material.recorded)
    return Error{"the motion has no frames; open another one", material.input.name};
  return PreparedSolver{std::move(material), std::move(synthesizer).value()};
}

}  // namespace abrazo
