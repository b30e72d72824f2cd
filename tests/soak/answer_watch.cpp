#include "tests/soak/answer_watch.hpp"

#include <execinfo.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

namespace abrazo::soak {
namespace {

constexpr int says_where = SIGUSR2;
constexpr auto look_every = std::chrono::milliseconds(50);

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Seconds for which a thread has ever run, and been ready to run without a processor.
struct Processor {
  double ran_s = 0, starved_s = 0;
};

/// 0 where the kernel does not count them. Takes no memory: a signal handler calls it.
Processor processor_of(pid_t thread) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "/proc/self/task/%d/schedstat", thread);
  const int file = ::open(text.data(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return {};
  const ssize_t length = ::read(file, text.data(), text.size() - 1);
  ::close(file);
  text[static_cast<std::size_t>(std::max<ssize_t>(length, 0))] = '\0';
  char* rest = nullptr;
  const std::uint64_t ran_ns = std::strtoull(text.data(), &rest, 10);
  return {static_cast<double>(ran_ns) / 1e9, static_cast<double>(std::strtoull(rest, nullptr, 10)) / 1e9};
}

/// What the signal handler sees of the one watch.
struct Watched {
  std::atomic<pid_t> id{0};
  std::atomic<double> beat_s{0}, ran_s{0}, starved_s{0}, limit_s{0};
  std::atomic<double> said_s{0};  ///< the beat before the gap that was reported
} watched;

/// In the watched thread. A wait for a processor is counted when it is over: so here, not in the thread that
/// watches. `addr2line -Cfipe PROGRAM ADDRESS` names the lines.
void say_where(int) {
  const double beat_s = watched.beat_s;
  if (watched.said_s == beat_s) return;
  if (now_s() - beat_s - (processor_of(watched.id).starved_s - watched.starved_s) <= watched.limit_s) return;
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
  const double now = now_s(), others_s = others_starved_s();
  const Processor had = processor_of(watched.id);
  Gap gap{now - watched.beat_s, had.starved_s - watched.starved_s};
  const double asleep_s = gap.own_s() - (had.ran_s - watched.ran_s);
  gap.starved_s += std::clamp(others_s, 0.0, std::max(asleep_s, 0.0));
  watched.ran_s = had.ran_s;
  watched.starved_s = had.starved_s;
  watched.beat_s = now;
  return gap;
}

double AnswerWatch::others_starved_s() {
  double longest_s = 0;
  std::map<pid_t, double> now;
  std::error_code ended;  // a thread may end while it is looked at
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task", ended)) {
    const auto thread = static_cast<pid_t>(std::strtol(entry.path().filename().c_str(), nullptr, 10));
    if (thread == watched.id) continue;
    const double ever_s = processor_of(thread).starved_s;
    const auto before = others_.find(thread);
    longest_s = std::max(longest_s, ever_s - (before == others_.end() ? 0 : before->second));
    now.emplace(thread, ever_s);
  }
  others_ = std::move(now);
  return longest_s;
}

void AnswerWatch::watch(const std::stop_token& stop) const {
  for (; !stop.stop_requested(); std::this_thread::sleep_for(look_every))
    if (now_s() - watched.beat_s > watched.limit_s) ::pthread_kill(watched_, says_where);
}

}  // namespace abrazo::soak
