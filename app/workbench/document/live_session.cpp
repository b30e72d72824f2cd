#include "app/workbench/document/live_session.hpp"

#include "core/stream/receive/clip_source.hpp"
#include "core/stream/receive/silent_source.hpp"
#include "core/stream/receive/whole_clip.hpp"

namespace abrazo::app {
namespace {

constexpr double pause_s = 1;  // between the recording and its continuation

std::shared_ptr<PoseSource> source_of(const Material& material) {
  if (!material.input_plays()) return std::make_shared<SilentSource>();
  if (material.is_clip()) return std::make_shared<WholeClip>(material.input);
  return std::make_shared<ClipSource>(material.input);
}

/// What comes after a recorded session lies behind it on the timeline.
SessionClock clock_of(const Material& material) {
  const auto start = SessionClock::Steady::now();
  if (!material.recorded) return SessionClock(start);
  const std::chrono::duration<double> before(material.recorded->last_s() + pause_s);
  return SessionClock(start - std::chrono::duration_cast<SessionClock::Steady::duration>(before));
}

}  // namespace

QString name_of_input(const Material& material) {
  if (material.use == InputUse::Stream) return "no stream";
  return (material.input_plays() ? "clip " : "recorded ") + QString::fromStdString(material.input.name);
}

QString title_of_input(const Material& material) {
  const QString name = name_of_input(material);
  return material.use == InputUse::Stream ? name
                                          : name + QString(" · %1 Hz").arg(material.input.fps, 0, 'f', 0);
}

LiveSession::LiveSession(PreparedSolver prepared)
    : m_material(std::move(prepared.material)),
      m_engine(std::move(prepared.synthesizer), source_of(m_material), clock_of(m_material),
               SessionOpeners::system(), m_material.recorded ? m_material.recorded->frames : nullptr) {}

void LiveSession::push(const Command& command) {
  const auto* settings = std::get_if<SetSettings>(&command);
  if (m_isHeld && settings)
    m_heldBack = *settings;
  else
    m_engine.push(command);
}

void LiveSession::holdSettings(bool on) {
  m_isHeld = on;
  if (on || !m_heldBack) return;
  m_engine.push(*m_heldBack);
  m_heldBack.reset();
}

void LiveSession::lookAt(const std::shared_ptr<const FrameStore>& frames) {
  if (!frames) return m_lookedAt.reset();
  if (!m_lookedAt) m_lookedAt = std::make_unique<LookedAt>();
  m_lookedAt->history.set_store(frames);
  m_lookedAt->latest.publish(frames->frame(frames->span().last_index));
}

RecordingFacts LiveSession::facts() const {
  RecordingFacts facts;
  facts.library_path = m_material.library_file;
  facts.library_name = m_material.library->name();
  facts.library_pairs = static_cast<std::uint64_t>(m_material.library->pair_count());
  facts.library = m_material.library;
  facts.excluded_takes = m_material.excluded_takes;
  facts.input = "clip:" + m_material.input.name;
  return facts;
}

void LiveSession::setLibraryFile(const std::shared_ptr<const MotionLibrary>& library,
                                 const std::string& file) {
  if (const auto recorder = m_engine.recorder()) recorder->set_library_path(library, file);
  if (m_material.library != library) return;
  m_material.library_file = file;
  m_material.unannotated.reset();
}

void LiveSession::replaceSolver(PreparedSolver prepared) {
  prepared.material.use = m_material.use;
  m_material = std::move(prepared.material);
  m_engine.push(ReplaceSynthesizer{std::move(prepared.synthesizer)});
}

}  // namespace abrazo::app
