#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/opening/material.hpp"
#include "core/session/run/session_engine.hpp"

namespace abrazo::app {

/// A solver that is ready to run; made on a worker because the index over the library takes its time.
struct PreparedSolver {
  Material material;
  std::unique_ptr<PartnerSynthesizer> synthesizer;
};

Result<PreparedSolver> prepare_solver(Material material, const Settings& settings);

/// The session that a window shows: a running engine, and what it was started on. Ends with this object.
class LiveSession {
 public:
  explicit LiveSession(PreparedSolver prepared);

  void push(const Command& command);
  /// While held, the solver keeps its settings; the last that were asked for meanwhile come when it is let
  /// go.
  void holdSettings(bool on);
  /// That the views show: the session's own frames, or those that are looked at in their place.
  const FrameHistory& history() const { return m_lookedAt ? m_lookedAt->history : m_engine.history(); }
  const LatestSlot<FrameSnapshot>& latest() const {
    return m_lookedAt ? m_lookedAt->latest : m_engine.latest();
  }
  /// Other frames than the session's own, which goes on meanwhile; null = its own again. Whoever reads
  /// history() lets go of it before it changes from one to the other; other frames may come in place of
  /// others at any time.
  void lookAt(const std::shared_ptr<const FrameStore>& frames);
  bool looksElsewhere() const { return m_lookedAt != nullptr; }
  const Material& material() const { return m_material; }
  /// The library was written to a file; one that was replaced meanwhile was not.
  void setLibraryFile(const std::shared_ptr<const MotionLibrary>& library, const std::string& file);
  /// The same session with a take added to its library, say: it goes on, with this from the next frame on.
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
