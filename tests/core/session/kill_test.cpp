#include <gtest/gtest.h>
#include <poll.h>

#include <cstdio>

#include "core/session/file/session_file.hpp"
#include "tests/core/session/recorded_session.hpp"
#include "tests/core/session/recording_process.hpp"

namespace abrazo::kill_test {
namespace {

class KilledRecording : public testing::TestWithParam<std::size_t> {};

TEST_P(KilledRecording, OpensAndHasAllButTheLastHalfSecond) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("killed.abrazo");
  test::RecordingProcess recording(path);
  ASSERT_TRUE(recording.read_until(GetParam()));
  const double killed_s = recording.kill_it();
  const auto file = SessionFile::open(path);
  ASSERT_TRUE(file) << file.error().text();
  std::uint64_t next = 0;
  const auto pass = (*file)->each_frame(-1e9, 1e9, [&](const FrameSnapshot& frame) -> Status {
    EXPECT_EQ(frame.index, next++);
    return Done{};
  });
  ASSERT_TRUE(pass);
  EXPECT_EQ(pass->damaged, 0U);
  EXPECT_GE(next, recording.lines().back().on_disk);  // what was said to be on disk is
  for (const auto& line : recording.lines()) {
    // A disk that needs longer for one commit says so in its delay.
    const double wait_s = std::max(0.5, recording.lines().back().behind_s + 0.4);
    if (line.handed_over_s < killed_s - wait_s) {
      EXPECT_LT(line.index, next);
    }
  }
  EXPECT_EQ((*file)->recovery().size(), 2U);  // that it was cut off, and the open take
  const auto& last = recording.lines().back();
  std::printf("frames handed over %zu, on disk %llu, lost %.3f s\n", recording.lines().size(),
              static_cast<unsigned long long>(next), static_cast<double>(last.index + 1 - next) / 120);
}

INSTANTIATE_TEST_SUITE_P(AfterFrames, KilledRecording, testing::Values(70U, 131U, 243U));

/// As a laptop that is closed, or a program in a debugger.
TEST(SuspendedRecording, GoesOnWithTheNewestPoseAndIsHonestAboutTheGap) {
  constexpr int asleep_ms = 1500;
  const test::TemporaryFolder folder;
  const std::string path = folder.file("suspended.abrazo");
  test::RecordingProcess recording(path);
  ASSERT_TRUE(recording.read_until(60));
  ASSERT_TRUE(recording.put_to_sleep());
  ::poll(nullptr, 0, asleep_ms);
  recording.wake();
  ASSERT_TRUE(recording.read_until(recording.lines().size() + 120));
  recording.kill_it();

  const auto& lines = recording.lines();
  std::size_t gaps = 0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].index, lines[i - 1].index + 1) << "indices have no hole";
    const double solved_s = lines[i].time_s - lines[i - 1].time_s;
    const double passed_s = lines[i].handed_over_s - lines[i - 1].handed_over_s;
    if (passed_s < 1) continue;
    ++gaps;
    EXPECT_NEAR(solved_s, passed_s, 0.5) << "what was slept through is not solved afterwards";
  }
  EXPECT_EQ(gaps, 1U);
  const auto file = SessionFile::open(path);
  ASSERT_TRUE(file) << file.error().text();
  double longest_s = 0;
  const auto pass = (*file)->each_frame(-1e9, 1e9, [&](const FrameSnapshot& frame) -> Status {
    longest_s = std::max(longest_s, frame.elapsed_s);
    EXPECT_NE(frame.result.status, StepStatus::Failed);
    EXPECT_GE(frame.times.solved_s, frame.times.taken_s);
    return Done{};
  });
  ASSERT_TRUE(pass);
  EXPECT_EQ(pass->damaged, 0U);
  EXPECT_GT(longest_s, 1) << "the frame after it says how long nothing was solved";
}

}  // namespace
}  // namespace abrazo::kill_test
