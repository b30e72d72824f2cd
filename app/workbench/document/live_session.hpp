#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/opening/prepared_solver.hpp"
#include "core/session/run/session_engine.hpp"

namespace abrazo::app {

/// What plays the user while no stream does: "clip salsa 02".
QString name_of_input(const Material& material);
/// "clip salsa 02 · 120 Hz".
QString title_of_input(const Material& material);

/// The session of a window: a running engine and its material. The destructor ends it.
class LiveSession {
 public:
  explicit LiveSession(PreparedSolver prepared);

  void push(const Command& command);
  /// While held, the solver keeps its settings; the last requested ones apply on release.
  void holdSettings(bool on);
  /// The shown frames: the session's, or those set by lookAt.
  const FrameHistory& history() const { return m_lookedAt ? m_lookedAt->history : m_engine.history(); }
  const LatestSlot<FrameSnapshot>& latest() const {
    return m_lookedAt ? m_lookedAt->latest : m_engine.latest();
  }
  /// Shows other frames while the session continues; null = its own frames. Readers of history() must release
  /// it before a change between own and other frames; other frames may be replaced at any time.
  void lookAt(const std::shared_ptr<const FrameStore>& frames);
  bool looksElsewhere() const { return m_lookedAt != nullptr; }
  const Material& material() const { return m_material; }
  /// Its own frames are shown, and they are those of a clip that is solved over its length.
  bool isClip() const { return m_material.is_clip() && !m_lookedAt; }
  /// What a recording of it says about its origin.
  RecordingFacts facts() const;
  /// Sets the file of the library after it was written; ignored if the library was replaced meanwhile.
  void setLibraryFile(const std::shared_ptr<const MotionLibrary>& library, const std::string& file);
  /// Continues the session with another solver from the next frame on, e.g. after a take was added to the
  /// library.
  void replaceSolver(PreparedSolver prepared);
  /// Streams, sinks, recording. Commands go through `push`.
  SessionEngine& engine() { return m_engine; }

 private:
  struct LookedAt {
    FrameHistory history;
    LatestSlot<FrameSnapshot> latest;
  };

  Material m_material;
  std::unique_ptr<LookedAt> m_lookedAt;
  bool m_isHeld = false;
  std::optional<SetSettings> m_heldBack;
  SessionEngine m_engine;
};

}  // namespace abrazo::app
