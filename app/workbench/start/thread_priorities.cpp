#include "app/workbench/start/thread_priorities.hpp"

#include <sys/resource.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/base/text.hpp"

namespace abrazo::app {
namespace {

constexpr int steps_back = 10;  ///< of 19; each gives about 20 % less where cores are short

}  // namespace

int make_software_renderer_stand_back() {
  int found = 0;
  std::error_code trouble;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task", trouble)) {
    std::string name;
    std::getline(std::ifstream(task.path() / "comm"), name);
    const auto thread = parse_integer(task.path().filename().string());
    if (!name.starts_with("llvmpipe") || !thread) continue;
    ++found;
    const auto id = static_cast<id_t>(*thread);
    if (getpriority(PRIO_PROCESS, id) < steps_back) setpriority(PRIO_PROCESS, id, steps_back);
  }
  return found;
}

}  // namespace abrazo::app
