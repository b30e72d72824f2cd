#include "core/session/solver_thread.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <stop_token>
#include <utility>

namespace abrazo {

namespace {

/// Commands and the wish to stop are noticed at least this often.
constexpr double longest_sleep_s = 0.005;

void run(LiveLoop& loop, const std::stop_token& stop) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const auto now_s = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  while (!stop.stop_requested()) {
    double due_s = now_s() + longest_sleep_s;
    try {
      due_s = std::min(due_s, loop.turn(now_s()));
    } catch (const std::exception& failure) {
      loop.publish_failure(failure.what(), now_s());
    }
    std::this_thread::sleep_until(
        start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(due_s)));
  }
}

}  // namespace

SolverThread::SolverThread(std::unique_ptr<LiveLoop> loop)
    : loop_(std::move(loop)), thread_([this](const std::stop_token& stop) { run(*loop_, stop); }) {}

}  // namespace abrazo
