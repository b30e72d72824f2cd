#include "tests/soak/answer_watch.hpp"

#include <execinfo.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>

namespace abrazo::soak {
namespace {

constexpr int says_where = SIGUSR2;
constexpr auto look_every = std::chrono::milliseconds(50);

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Seconds for which the thread has ever been ready to run without a processor; 0 where the kernel does not
/// count them.
double starved_ever_s(pid_t thread) {
  std::ifstream file("/proc/self/task/" + std::to_string(thread) + "/schedstat");
  std::uint64_t ran_ns = 0, waited_ns = 0;
  file >> ran_ns >> waited_ns;
  return static_cast<double>(waited_ns) / 1e9;
}

/// `addr2line -Cfipe PROGRAM ADDRESS` names the lines.
void say_where(int) {
  std::array<void*, 60> calls{};
  const char* words = "  it is in\n";
  if (::write(STDOUT_FILENO, words, std::strlen(words)) < 0) return;
  ::backtrace_symbols_fd(calls.data(), ::backtrace(calls.data(), static_cast<int>(calls.size())),
                         STDOUT_FILENO);
}

}  // namespace

AnswerWatch::AnswerWatch(double limit_s) : limit_s_(limit_s), watched_(::pthread_self()), id_(::gettid()) {
  void* caller = nullptr;
  ::backtrace(&caller, 1);  // the first call loads a library, which a signal handler cannot do
  std::signal(says_where, say_where);
  beat();
  watching_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
}

AnswerWatch::~AnswerWatch() = default;

AnswerWatch::Gap AnswerWatch::beat() {
  const double now = now_s(), starved = starved_ever_s(id_);
  const Gap gap{now - beat_s_, starved - starved_s_};
  starved_s_ = starved;
  beat_s_ = now;
  return gap;
}

void AnswerWatch::watch(const std::stop_token& stop) const {
  double said_s = 0;  // the beat before the gap that was reported
  for (; !stop.stop_requested(); std::this_thread::sleep_for(look_every)) {
    const double beat_s = beat_s_, starved_s = starved_ever_s(id_) - starved_s_;
    if (beat_s == said_s || now_s() - beat_s - starved_s <= limit_s_) continue;
    said_s = beat_s;
    ::pthread_kill(watched_, says_where);
  }
}

}  // namespace abrazo::soak
