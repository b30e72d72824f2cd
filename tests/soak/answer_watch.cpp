#include "tests/soak/answer_watch.hpp"

#include <execinfo.h>
#include <fcntl.h>
#include <semaphore.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stop_token>
#include <string_view>
#include <system_error>
#include <utility>

namespace abrazo::soak {
namespace {

constexpr int where = SIGUSR2;  ///< asks it
constexpr auto look_every = std::chrono::milliseconds(50);
constexpr double look_after_s = 0.1;

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

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

/// What the signal handler sees of the one watch, and what it tells: the calls that the watched thread is in.
struct Watched {
  std::atomic<pid_t> id{0};
  std::atomic<double> beat_s{0}, starved_s{0}, limit_s{0};
  std::atomic<double> said_s{0};  ///< the beat before the gap that was reported
  std::array<void*, 60> calls{};  ///< written before the semaphore is raised, read after
  int call_count = 0;
  sem_t told{};
} watched;

/// In the watched thread. A wait for a processor is counted when it is over: so here, not in the thread that
/// watches. `addr2line -Cfipe PROGRAM ADDRESS` names the lines.
void tell_where(int) {
  const int error = errno;
  watched.call_count = ::backtrace(watched.calls.data(), static_cast<int>(watched.calls.size()));
  const double beat_s = watched.beat_s;
  const double own_s = now_s() - beat_s - (processor_of(watched.id).starved_s - watched.starved_s);
  if (watched.said_s != beat_s && own_s > watched.limit_s) {
    watched.said_s = beat_s;
    constexpr std::string_view words = "  it is in\n";
    if (::write(STDOUT_FILENO, words.data(), words.size()) >= 0)
      ::backtrace_symbols_fd(watched.calls.data(), watched.call_count, STDOUT_FILENO);
  }
  ::sem_post(&watched.told);
  errno = error;
}

std::string name_of(const std::filesystem::path& thread) {
  std::ifstream file(thread / "comm");
  std::string name;
  std::getline(file, name);
  return name;
}

}  // namespace

Driver software_driver() {
  return {{"swrast_dri.so", "libgallium"}, "llvmpipe"};
}

AnswerWatch::AnswerWatch(double limit_s, Driver driver)
    : driver_(std::move(driver)), watched_(::pthread_self()) {
  void* caller = nullptr;
  ::backtrace(&caller, 1);  // the first call loads a library, which a signal handler cannot do
  ::sem_init(&watched.told, 0, 0);
  watched.id = ::gettid();
  watched.limit_s = limit_s;
  beat();
  std::signal(where, tell_where);
  watching_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
}

AnswerWatch::~AnswerWatch() = default;

AnswerWatch::Gap AnswerWatch::beat() {
  const std::lock_guard lock(mutex_);
  Sight sight{now_s(), processor_of(watched.id), false, {}};
  if (is_looked_at_) sight.renderers_s = renderers_s();
  is_looked_at_ = false;
  watched.starved_s = sight.watched.starved_s;
  watched.beat_s = sight.now_s;
  return account_.beat(sight);
}

/// Of each thread that draws, how long ever without a processor.
std::map<pid_t, double> AnswerWatch::renderers_s() const {
  std::map<pid_t, double> found;
  std::error_code ended;  // a thread may end while it is looked at
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task", ended)) {
    if (!name_of(entry.path()).starts_with(driver_.threads)) continue;
    const auto thread = static_cast<pid_t>(std::strtol(entry.path().filename().c_str(), nullptr, 10));
    found.emplace(thread, processor_of(thread).starved_s);
  }
  return found;
}

/// Not asked of the loader: the watched thread may have its lock, while it loads a library.
bool AnswerWatch::is_in_driver() const {
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    const std::string file = line.substr(line.rfind('/') + 1);
    if (std::none_of(driver_.libraries.begin(), driver_.libraries.end(),
                     [&](const std::string& library) { return file.starts_with(library); }))
      continue;
    char* rest = nullptr;
    const std::uintptr_t begin = std::strtoull(line.c_str(), &rest, 16);
    const std::uintptr_t end = std::strtoull(rest + 1, nullptr, 16);  // begin-end permissions ... file
    for (int i = 0; i < watched.call_count; ++i)
      if (const auto call = reinterpret_cast<std::uintptr_t>(watched.calls[i]); begin <= call && call < end)
        return true;
  }
  return false;
}

void AnswerWatch::look() {
  const double beat_s = watched.beat_s;
  if (::pthread_kill(watched_, where) != 0) return;
  while (::sem_wait(&watched.told) != 0) {
  }
  const bool in_driver = is_in_driver();
  const std::lock_guard lock(mutex_);
  if (watched.beat_s != beat_s) return;  // it has answered meanwhile
  account_.look({now_s(), processor_of(watched.id), in_driver, renderers_s()});
  is_looked_at_ = true;
}

void AnswerWatch::watch(const std::stop_token& stop) {
  for (; !stop.stop_requested(); std::this_thread::sleep_for(look_every))
    if (now_s() - watched.beat_s > look_after_s) look();
}

}  // namespace abrazo::soak
