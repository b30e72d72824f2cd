#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QSignalSpy>
#include <atomic>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/start/responsiveness.hpp"
#include "app/workbench/start/start_times.hpp"
#include "app/workbench/start/status_lines.hpp"
#include "app/workbench/start/termination.hpp"
#include "app/workbench/start/thread_priorities.hpp"

namespace abrazo::app::endurance_test {
namespace {

using Json = nlohmann::json;

TEST(Termination, ASignalOfTheSystemArrivesInTheEventLoop) {
  const Termination termination;
  QSignalSpy asked(&termination, &Termination::requested);
  std::raise(SIGTERM);
  EXPECT_EQ(asked.count(), 0) << "a handler may do nothing itself";
  ASSERT_TRUE(asked.wait(5000));
  EXPECT_EQ(asked.count(), 1);
}

TEST(Termination, ASecondWishEndsTheProgramAtOnce) {
  EXPECT_EXIT(
      {
        const Termination termination;
        std::raise(SIGTERM);
        std::raise(SIGTERM);
      },
      testing::KilledBySignal(SIGTERM), "");
}

TEST(Termination, LeavesTheSignalsAsTheyWere) {
  { const Termination termination; }
  struct sigaction found {};
  ASSERT_EQ(sigaction(SIGTERM, nullptr, &found), 0);
  EXPECT_EQ(found.sa_handler, SIG_DFL);
}

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

TEST(ThreadPriorities, OnlyTheThreadsThatDrawStandBack) {
  const int of_the_renderer = make_software_renderer_stand_back();  // where something has drawn already
  const Waiting drawing("llvmpipe-7"), other("solver");
  EXPECT_EQ(make_software_renderer_stand_back(), of_the_renderer + 1);
  const int before = getpriority(PRIO_PROCESS, 0);
  EXPECT_EQ(getpriority(PRIO_PROCESS, static_cast<id_t>(drawing.id())), std::max(before, 10));
  EXPECT_EQ(getpriority(PRIO_PROCESS, static_cast<id_t>(other.id())), before);
}

int cores_of(pid_t thread) {
  cpu_set_t cores;
  return sched_getaffinity(thread, sizeof cores, &cores) == 0 ? CPU_COUNT(&cores) : -1;
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
  if (make_software_renderer_stand_back() > 0) GTEST_SKIP() << "one draws already";
  const int all = cores_of(0);
  CoresForAnswers cores;
  cores.keep(true);
  EXPECT_FALSE(cores.are_kept());
  EXPECT_EQ(cores_of(getpid()), all);
}

TEST(StartTimes, EachStageCountsTheFirstTime) {
  StartTimes start;
  start.reached("window shown");
  start.reached("first picture");
  start.reached("window shown");
  ASSERT_EQ(start.stages().size(), 2u);
  EXPECT_LE(start.stages()[0].after_ms, start.stages()[1].after_ms);
  EXPECT_TRUE(start.text().contains("ms  first picture\n"));
}

TEST(StartTimes, TheProcessIsOlderThanThisTest) {
  const double first_ms = since_process_start_ms();
  EXPECT_GT(first_ms, 0);
  EXPECT_LT(first_ms, 600'000);
  EXPECT_GE(since_process_start_ms(), first_ms);
}

TEST(StatusLines, OfAWindowWithoutASessionALineIsWholeJson) {
  UserSettings remembered;
  MainWindow window(remembered);
  const Responsiveness responsiveness;
  StatusLines lines(window.document(), window.scene(), responsiveness, 1, [](const std::string&) {});
  const std::string line = lines.line();
  ASSERT_EQ(line.back(), '\n');
  const Json json = Json::parse(line);
  EXPECT_EQ(json["solved"], 0);
  EXPECT_EQ(json["pictures"], 0);
  EXPECT_FALSE(json.contains("recording"));
}

}  // namespace
}  // namespace abrazo::app::endurance_test
