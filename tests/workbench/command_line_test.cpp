#include "app/workbench/start/command_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace abrazo::app::command_line_test {
namespace {

std::variant<CommandLine, ExitStatus> parsed(std::vector<std::string> words) {
  words.insert(words.begin(), "abrazo-workbench");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  return parse_command_line(static_cast<int>(argv.size()), argv.data());
}

int exit_code(const std::vector<std::string>& words) {
  const auto result = parsed(words);
  const auto* stop = std::get_if<ExitStatus>(&result);
  return stop ? stop->code : -1;
}

TEST(CommandLine, TakesFilesAndOptions) {
  const auto result = parsed({"walk.bvh", "--library", "salsa.h5", "--size", "1280x720", "--smoke", "30"});
  const auto& asked = std::get<CommandLine>(result);
  EXPECT_EQ(asked.files, (std::vector<std::string>{"walk.bvh"}));
  EXPECT_EQ(asked.library, "salsa.h5");
  EXPECT_EQ(asked.size, QSize(1280, 720));
  EXPECT_EQ(asked.smoke_frames, 30);
  EXPECT_TRUE(asked.unattended());
}

TEST(CommandLine, WrongUsageIsStatusTwo) {
  EXPECT_EQ(exit_code({"--smoke", "none"}), 2);
  EXPECT_EQ(exit_code({"--no-such-option"}), 2);
  EXPECT_EQ(exit_code({"--size", "tiny"}), 2);
  EXPECT_EQ(exit_code({"--demo", "walk.bvh"}), 2) << "one of the two would be ignored";
}

TEST(CommandLine, HelpAndVersionAreStatusZero) {
  EXPECT_EQ(exit_code({"--help"}), 0);
  EXPECT_EQ(exit_code({"--version"}), 0);
}

TEST(CommandLine, AStreamToFollowAndPlacesToSendToAreUris) {
  const auto result = parsed({"--listen", "natnet://10.0.0.2?multicast=239.255.42.99", "--send",
                              "vmc://127.0.0.1:39540", "--send", "vmc://127.0.0.1:39541"});
  const auto* asked = std::get_if<CommandLine>(&result);
  ASSERT_NE(asked, nullptr);
  EXPECT_EQ(asked->listen, "natnet://10.0.0.2?multicast=239.255.42.99");
  EXPECT_EQ(asked->send.size(), 2U);
  EXPECT_EQ(exit_code({"--listen", "ftp://here"}), 2);
  EXPECT_EQ(exit_code({"--send", "vmc://here:99999"}), 2);
}

TEST(CommandLine, TakesARecordedSession) {
  const auto result = parsed({"--session", "a.abrazo"});
  EXPECT_EQ(std::get<CommandLine>(result).session, "a.abrazo");
}

TEST(CommandLine, WhateverIsSaidOfTheSizeIsASizeOrRefusedInOneLine) {
  std::mt19937 random(20261122);
  const std::string letters = "0123456789x16384.-+ e\n\x1b\x7f,X";
  int taken = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string word = round % 2 == 0
                           ? std::to_string(640 + random() % 17'000) + "x" + std::to_string(random() % 17'000)
                           : std::string();
    for (auto length = random() % (round % 4 == 0 ? 1 : 7); length > 0; --length)
      word += letters[random() % letters.size()];
    testing::internal::CaptureStderr();
    const auto result = parsed({"--size=" + word});
    const std::string said = testing::internal::GetCapturedStderr();
    if (const auto* asked = std::get_if<CommandLine>(&result)) {
      ++taken;
      EXPECT_TRUE(asked->size.width() >= 640 && asked->size.width() <= 16384) << word;
      EXPECT_TRUE(asked->size.height() >= 400 && asked->size.height() <= 16384) << word;
      continue;
    }
    EXPECT_EQ(std::get<ExitStatus>(result).code, 2) << word;
    EXPECT_EQ(std::count_if(said.begin(), said.end(), [](char c) { return c > 0 && c < 0x20; }), 1) << said;
    EXPECT_EQ(said.find('\x7f'), std::string::npos) << said;
  }
  EXPECT_GT(taken, 100) << "the words were too odd";
}

TEST(CommandLine, AWordThatIsNotExpectedDoesNotSteerTheTerminal) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(exit_code({"--theme=\x1b[2J\nFORGED"}), 2);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("?[2J?FORGED"), std::string::npos) << said;
}

}  // namespace
}  // namespace abrazo::app::command_line_test
