#include "tests/soak/answer_watch.hpp"

#include <execinfo.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace abrazo::soak {
namespace {

constexpr int says_where = SIGUSR2;
constexpr auto look_every = std::chrono::milliseconds(50);

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Seconds for which the thread has ever been ready to run without a processor; 0 where the kernel does not
/// count them. Takes no memory: a signal handler calls it.
double starved_ever_s(pid_t thread) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "/proc/self/task/%d/schedstat", thread);
  const int file = ::open(text.data(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return 0;
  const ssize_t length = ::read(file, text.data(), text.size() - 1);
  ::close(file);
  text[static_cast<std::size_t>(std::max<ssize_t>(length, 0))] = '\0';
  char* rest = nullptr;
  (void)std::strtoull(text.data(), &rest, 10);  // what it ran
  return static_cast<double>(std::strtoull(rest, nullptr, 10)) / 1e9;
}

/// What the signal handler sees of the one watch.
struct Watched {
  std::atomic<pid_t> id{0};
  std::atomic<double> beat_s{0}, starved_s{0}, limit_s{0};
  std::atomic<double> said_s{0};  ///< the beat before the gap that was reported
} watched;

/// In the watched thread. A wait for a processor is counted when it is over: so here, not in the thread that
/// watches. `addr2line -Cfipe PROGRAM ADDRESS` names the lines.
void say_where(int) {
  const double beat_s = watched.beat_s;
  if (watched.said_s == beat_s) return;
  if (now_s() - beat_s - (starved_ever_s(watched.id) - watched.starved_s) <= watched.limit_s) return;
  watched.said_s = beat_s;
  std::array<void*, 60> calls{};
  constexpr std::string_view words = "  it is in\n";
  if (::write(STDOUT_FILENO, words.data(), words.size()) < 0) return;
  ::backtrace_symbols_fd(calls.data(), ::backtrace(calls.data(), static_cast<int>(calls.size())),
                         STDOUT_FILENO);
}

}  // namespace

AnswerWatch::AnswerWatch(double limit_s) : watched_(::pthread_self()) {
  void* caller = nullptr;
  ::backtrace(&caller, 1);  // the first call loads a library, which a signal handler cannot do
  watched.id = ::gettid();
  watched.limit_s = limit_s;
  beat();
  std::signal(says_where, say_where);
  watching_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
}

AnswerWatch::~AnswerWatch() = default;

AnswerWatch::Gap AnswerWatch::beat() {
  const double now = now_s(), starved = starved_ever_s(watched.id);
  const Gap gap{now - watched.beat_s, starved - watched.starved_s};
  watched.starved_s = starved;
  watched.beat_s = now;
  return gap;
}

void AnswerWatch::watch(const std::stop_token& stop) const {
  for (; !stop.stop_requested(); std::this_thread::sleep_for(look_every))
    if (now_s() - watched.beat_s > watched.limit_s) ::pthread_kill(watched_, says_where);
}

}  // namespace abrazo::soak
