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

TEST(ThreadPriorities, OnlyTheThreadsThatDrawStandBack) {
  std::atomic<bool> ends = false;
  std::atomic<pid_t> drawing = 0, other = 0;
  const auto run = [&ends](const char* name, std::atomic<pid_t>& id) {
    return std::thread([&ends, name, &id] {
      pthread_setname_np(pthread_self(), name);
      id = gettid();
      while (!ends) ends.wait(false);
    });
  };
  const int of_the_renderer = make_software_renderer_stand_back();  // where something has drawn already
  std::thread first = run("llvmpipe-7", drawing), second = run("solver", other);
  while (drawing == 0 || other == 0) std::this_thread::yield();
  EXPECT_EQ(make_software_renderer_stand_back(), of_the_renderer + 1);
  const int before = getpriority(PRIO_PROCESS, 0);
  EXPECT_EQ(getpriority(PRIO_PROCESS, static_cast<id_t>(drawing)), std::max(before, 10));
  EXPECT_EQ(getpriority(PRIO_PROCESS, static_cast<id_t>(other)), before);
  ends = true;
  ends.notify_all();
  first.join();
  second.join();
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
