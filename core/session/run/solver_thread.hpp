#pragma once

#include <memory>
#include <thread>

#include "core/base/session_clock.hpp"
#include "core/session/run/live_loop.hpp"

namespace abrazo {

/// Runs a LiveLoop in real time until it is destroyed, which waits for the running step at most. Sleeps until
/// the next pose is due or a command or pose came in. An exception becomes a failed snapshot with its text.
class SolverThread {
 public:
  explicit SolverThread(std::unique_ptr<LiveLoop> loop, SessionClock clock = SessionClock());

 private:
  std::unique_ptr<LiveLoop> loop_;
  std::jthread thread_;  // after what it uses: stops first
};

}  // namespace abrazo
