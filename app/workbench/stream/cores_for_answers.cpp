#include "app/workbench/stream/cores_for_answers.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/base/text.hpp"

namespace abrazo::app {
namespace {

constexpr int cores_per_kept = 4;

struct Threads {
  std::vector<pid_t> rendering, other;
};

Threads threads_of_this_process() {
  Threads found;
  std::error_code trouble;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task", trouble)) {
    std::string name;
    std::getline(std::ifstream(task.path() / "comm"), name);
    const auto id = parse_integer(task.path().filename().string());
    if (id) (name.starts_with("llvmpipe") ? found.rendering : found.other).push_back(static_cast<pid_t>(*id));
  }
  return found;
}

void use(const cpu_set_t& cores, pid_t thread) {
  static_cast<void>(sched_setaffinity(thread, sizeof cores, &cores));  // it may have ended
}

}  // namespace

CoresForAnswers::CoresForAnswers() {
  if (sched_getaffinity(0, sizeof all_, &all_) != 0) return;
  drawing_ = all_;
  const int cores = CPU_COUNT(&all_);
  int kept = std::max(1, cores / cores_per_kept);
  // The last ones: devices mostly interrupt the first.
  for (int core = CPU_SETSIZE - 1; core >= 0 && kept > 0; --core)
    if (CPU_ISSET(core, &drawing_)) {
      CPU_CLR(core, &drawing_);
      --kept;
    }
}

void CoresForAnswers::keep(bool wanted) {
  if ((!wanted && !are_kept_) || CPU_COUNT(&drawing_) == 0) return;
  const Threads threads = threads_of_this_process();
  are_kept_ = wanted && !threads.rendering.empty();
  const cpu_set_t& drawing = are_kept_ ? drawing_ : all_;
  for (const pid_t thread : threads.rendering) use(drawing, thread);
  for (const pid_t thread : threads.other) use(thread == getpid() ? drawing : all_, thread);
}

}  // namespace abrazo::app
