#include <gtest/gtest.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QSignalSpy>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/start/responsiveness.hpp"
#include "app/workbench/start/start_times.hpp"
#include "app/workbench/start/status_lines.hpp"
#include "app/workbench/start/termination.hpp"

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
  window.setPlaysAsLive(true);
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
