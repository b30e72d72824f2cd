#include "app/workbench/stream/cores_for_answers.hpp"

#include <gtest/gtest.h>
#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

namespace abrazo::app::cores_for_answers_test {
namespace {

/// A thread that waits until it is let go.
class Waiting {
 public:
  explicit Waiting(const char* name) {
    thread_ = std::thread([this, name] {
      pthread_setname_np(pthread_self(), name);
      id_ = gettid();
      while (!ends_) ends_.wait(false);
    });
    while (id_ == 0) std::this_thread::yield();
  }
  ~Waiting() {
    ends_ = true;
    ends_.notify_all();
    thread_.join();
  }
  pid_t id() const { return id_; }

 private:
  std::atomic<bool> ends_ = false;
  std::atomic<pid_t> id_ = 0;
  std::thread thread_;
};

int cores_of(pid_t thread) {
  cpu_set_t cores;
  return sched_getaffinity(thread, sizeof cores, &cores) == 0 ? CPU_COUNT(&cores) : -1;
}

bool something_draws_in_software() {
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::string name;
    std::getline(std::ifstream(task.path() / "comm"), name);
    if (name.starts_with("llvmpipe")) return true;
  }
  return false;
}

TEST(CoresForAnswers, ThreadsThatDrawLeaveAQuarterOfTheCoresAndTakeThemBack) {
  const int all = cores_of(0);
  if (all < 2) GTEST_SKIP() << "needs two cores";
  const int drawing = all - std::max(1, all / 4);
  const Waiting renderer("llvmpipe-7"), solver("solver");
  {
    CoresForAnswers cores;
    cores.keep(true);
    EXPECT_TRUE(cores.are_kept());
    EXPECT_EQ(cores_of(renderer.id()), drawing);
    EXPECT_EQ(cores_of(getpid()), drawing) << "the window's thread draws too";
    EXPECT_EQ(cores_of(solver.id()), all);

    const Waiting begun_meanwhile("job");
    cores.keep(true);
    EXPECT_EQ(cores_of(begun_meanwhile.id()), all);

    cores.keep(false);
    EXPECT_EQ(cores_of(renderer.id()), all);
    EXPECT_EQ(cores_of(getpid()), all);
    cores.keep(true);
  }
  EXPECT_EQ(cores_of(renderer.id()), all) << "whoever kept them ended";
}

TEST(CoresForAnswers, NothingChangesWithoutASoftwareRenderer) {
  if (something_draws_in_software()) GTEST_SKIP() << "one draws already";
  const int all = cores_of(0);
  CoresForAnswers cores;
  cores.keep(true);
  EXPECT_FALSE(cores.are_kept());
  EXPECT_EQ(cores_of(getpid()), all);
}

}  // namespace
}  // namespace abrazo::app::cores_for_answers_test
