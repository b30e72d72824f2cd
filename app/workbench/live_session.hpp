#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/workbench/material.hpp"
#include "core/base/result.hpp"
#include "core/session/command_queue.hpp"
#include "core/session/frame_history.hpp"
#include "core/session/latest_slot.hpp"
#include "core/session/solver_thread.hpp"

namespace abrazo::app {

/// A solver that is ready to run; made on a worker because the index over the library takes its time.
struct PreparedSolver {
  Material material;
  std::unique_ptr<PartnerSynthesizer> synthesizer;
};

Result<PreparedSolver> prepare_solver(Material material, const Settings& settings);

/// One running solver with what it writes to. Ends with this object.
class LiveSession {
 public:
  explicit LiveSession(PreparedSolver prepared);

  void push(const Command& command);
  /// While held, the solver keeps its settings; the last that were asked for meanwhile come when it is let
  /// go.
  void holdSettings(bool on);
  const FrameHistory& history() const { return m_history; }
  const LatestSlot<FrameSnapshot>& latest() const { return m_latest; }
  const Material& material() const { return m_material; }

 private:
  Material m_material;
  bool m_isHeld = false;
  std::optional<SetSettings> m_heldBack;
  CommandQueue m_commands;
  FrameHistory m_history;
  LatestSlot<FrameSnapshot> m_latest;
  SolverThread m_solver;  // last in, first out
};

}  // namespace abrazo::app
