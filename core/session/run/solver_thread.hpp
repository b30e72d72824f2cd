#pragma once

#include <memory>
#include <optional>
#include <thread>

#include "core/base/session_clock.hpp"
#include "core/session/run/live_loop.hpp"

namespace abrazo {

/// Runs a LiveLoop in real time. The destructor waits for the running step at most. Sleeps until the next
/// pose is due or a command or pose arrives. An exception becomes a failed snapshot with its text.
class SolverThread {
 public:
  explicit SolverThread(std::unique_ptr<LiveLoop> loop, SessionClock clock = SessionClock());

  bool is_held() const { return loop_->is_held(); }
  std::optional<LiveLoop::ClipProgress> clip_progress() const { return loop_->clip_progress(); }
  void look_at(double clip_time_s) { loop_->look_at(clip_time_s); }

 private:
  std::unique_ptr<LiveLoop> loop_;
  std::jthread thread_;  // declared after what it uses: stops first
};

}  // namespace abrazo
