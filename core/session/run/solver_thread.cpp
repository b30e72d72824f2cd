#include "core/session/run/solver_thread.hpp"

#include <algorithm>
#include <exception>
#include <stop_token>
#include <string>
#include <utility>

#include "core/base/thread_urgency.hpp"

namespace abrazo {

namespace {

/// Polling interval of a source that does not report arrivals.
constexpr double longest_sleep_s = 0.005;
/// Most steps take less.
constexpr double usual_step_s = 1e-3;
/// The same failure over and over is one frame so often, not one each turn.
constexpr double between_failures_s = 1;

/// Failures on their way into the history, without flooding it.
class FailureNotes {
 public:
  explicit FailureNotes(LiveLoop& loop) : loop_(loop) {}
  void note(const std::string& why, double now_s) {
    if (why == last_ && now_s - last_s_ < between_failures_s) return;
    last_ = why;
    last_s_ = now_s;
    loop_.publish_failure(why, now_s);
  }

 private:
  LiveLoop& loop_;
  std::string last_;
  double last_s_ = 0;
};

void run(LiveLoop& loop, const SessionClock& clock, const std::stop_token& stop) {
  if (!loop.clip_progress()) let_this_thread_go_first(usual_step_s);  // of a clip nobody waits for a frame
  const std::stop_callback wake_to_stop(stop, [&] { loop.wake_up()->notify(); });
  FailureNotes failures(loop);
  while (!stop.stop_requested()) {
    double due_s = clock.now_s() + longest_sleep_s;
    try {
      due_s = std::min(due_s, loop.turn(clock.now_s()));
    } catch (const std::exception& failure) {
      failures.note(failure.what(), clock.now_s());
    }
    loop.wake_up()->wait_until(clock.at(due_s));
  }
}

}  // namespace

SolverThread::SolverThread(std::unique_ptr<LiveLoop> loop, SessionClock clock)
    : loop_(std::move(loop)),
      thread_([this, clock](const std::stop_token& stop) { run(*loop_, clock, stop); }) {}

}  // namespace abrazo
