#include "app/workbench/live_session.hpp"

#include "core/stream/clip_source.hpp"

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

void LiveSession::push(const Command& command) {
  const auto* settings = std::get_if<SetSettings>(&command);
  if (m_isHeld && settings)
    m_heldBack = *settings;
  else
    m_commands.push(command);
}

void LiveSession::holdSettings(bool on) {
  m_isHeld = on;
  if (on || !m_heldBack) return;
  m_commands.push(*m_heldBack);
  m_heldBack.reset();
}

}  // namespace abrazo::app
