#include "app/workbench/live_session.hpp"

namespace abrazo::app {

Result<PreparedSolver> prepare_solver(Material material, const Settings& settings) {
  auto synthesizer = PartnerSynthesizer::create(material.library, settings, material.excluded_takes);
  if (!synthesizer) return synthesizer.error();
  if (material.input.poses.empty())
    return Error{"the motion has no frames; open another one", material.input.name};
  return PreparedSolver{std::move(material), std::move(synthesizer).value()};
}

LiveSession::LiveSession(PreparedSolver prepared)
    : m_material(std::move(prepared.material)),
      m_solver(std::make_unique<LiveLoop>(std::move(prepared.synthesizer),
                                          std::make_unique<ClipSource>(m_material.input), m_commands,
                                          m_history, m_latest)) {}

}  // namespace abrazo::app
