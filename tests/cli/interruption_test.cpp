#include <unistd.h>

#include <chrono>
#include <csignal>
#include <memory>
#include <thread>

#include "app/cli/interruption.hpp"
#include "tests/cli/command_line_fixture.hpp"

namespace abrazo::test::interruption_test {
namespace {

using ::testing::HasSubstr;

class Interruption : public CommandLineTest {
 protected:
  /// Starts a run of about a second that writes a trace, and waits until it has begun to.
  void start_a_long_run() {
    make_library();
    std::vector<std::string> words = {ABRAZO_PROGRAM,
                                      "synth",
                                      "--quiet",
                                      "--library",
                                      "demo.h5",
                                      "--input",
                                      "demo/salsa_01_a.bvh",
                                      "--trace",
                                      "t.jsonl",
                                      "-o",
                                      "pair.bvh",
                                      "--step-rate",
                                      "60",
                                      "--morph-steps",
                                      "20",
                                      "--projection-steps",
                                      "10"};
    command_ = std::make_unique<RunningCommand>(words, folder());
    while (names().size() < 3 && !command_->finished())
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  std::unique_ptr<RunningCommand> command_;
};

TEST_F(Interruption, LeavesNoFileBehindAndSaysSo) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    start_a_long_run();
    ASSERT_FALSE(command_->finished()) << "too quick to be interrupted";
    command_->signal(number);
    const Outcome outcome = command_->wait();
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("cancelled"));
    EXPECT_THAT(names(), ::testing::ElementsAre("demo", "demo.h5"));
  }
}

TEST(InterruptionDeathTest, EndsAlsoAProgramThatWaitsForSomethingElse) {
  const auto wait_for_ever = [] {
    app::note_interruptions(1);
    std::raise(SIGTERM);
    while (true) ::pause();
  };
  EXPECT_EXIT(wait_for_ever(), testing::KilledBySignal(SIGTERM), "");
}

TEST_F(Interruption, TheSecondEndsTheProgramAtOnce) {
  start_a_long_run();
  ASSERT_TRUE(command_->catches(SIGTERM));
  command_->signal(SIGTERM);
  while (command_->catches(SIGTERM) && !command_->finished())
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  command_->signal(SIGTERM);
  EXPECT_EQ(command_->wait().status, 128 + SIGTERM);
}

TEST_F(Interruption, WhatStoodThereStaysWhenARunIsInterrupted) {
  write("t.jsonl", "mine");
  make_library();
  std::vector<std::string> words = {ABRAZO_PROGRAM,        "synth",   "--library", "demo.h5",  "--input",
                                    "demo/salsa_01_a.bvh", "--trace", "t.jsonl",   "--preset", "responsive"};
  RunningCommand command(words, folder());
  while (names().size() < 4 && !command.finished()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  command.signal(SIGINT);
  EXPECT_EQ(command.wait().status, 1);
  EXPECT_EQ(read("t.jsonl"), "mine");
  EXPECT_THAT(names(), ::testing::ElementsAre("demo", "demo.h5", "t.jsonl"));
}

TEST_F(Interruption, AFileOfAStrangerThatHoldsItsReaderUpIsLetGoAtTheFirstSignal) {
  write("slow.fbx", "; FBX 7.4.0 project file\n");
  write("reader", "#!/bin/sh\ntouch begun\ntrap '' TERM INT HUP\nwhile :; do :; done\n");
  std::filesystem::permissions(path("reader"), std::filesystem::perms::owner_all);
  RunningCommand command({"/usr/bin/env", "ABRAZO_SCENE_READER=" + path("reader").string(), ABRAZO_PROGRAM,
                          "motion", "info", "slow.fbx"},
                         folder());
  while (names().size() < 3 && !command.finished()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const auto begin = std::chrono::steady_clock::now();
  command.signal(SIGTERM);
  const Outcome outcome = command.wait();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("slow.fbx: cancelled"));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
}

}  // namespace
}  // namespace abrazo::test::interruption_test
