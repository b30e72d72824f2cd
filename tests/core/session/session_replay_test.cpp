#include "core/session/run/session_replay.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/synthesis/frames/trace.hpp"
#include "tests/core/session/recorded_session.hpp"
#include "tests/support/settings.hpp"

namespace abrazo::session_replay_test {
namespace {

std::string trace_line(const FrameSnapshot& frame) {
  FrameResult timeless = frame.result;
  timeless.timing = {};
  return trace_frame_line(timeless, *test::session_library(), frame.input_frame, frame.time_s);
}

/// A session in which everything happened that a person can do.
struct Eventful : test::TemporaryFolder, test::DrivenSession {
  Eventful() : path(file("s.abrazo")) {
    keeper->recorder = *Recorder::open(path, test::session_facts());
    run_until(0.4);
    commands.push(PinPair{33});
    run_until(0.7);
    commands.push(PinPair{std::nullopt});
    commands.push(SetVetoes{{{}, {"first"}, {}}});
    run_until(1.1);
    Settings settings = *preset("paper");
    settings.foot_locks = false;
    settings.alpha = 1.0 / 3;
    commands.push(SetSettings{settings});
    run_until(1.4);
    settings = test::responsive_by_pose();
    settings.user_role = UserRole::Passive;
    commands.push(SetSettings{settings});
    run_until(1.8);
    commands.push(ResetSolver{});
    run_until(2.0);
    commands.push(IntendMove{IntendedMove{std::nullopt, "second"}});
    run_until(2.3);
    commands.push(SeekInput{0.3});
    run_until(2.5);
    commands.push(ReplaceSource{std::make_shared<ClipSource>(test::swinging_take("other", 200, 9).b)});
    run_until(3.5);
    EXPECT_TRUE(keeper->recorder->finish());
  }
  std::string path;
};

TEST(SessionReplay, GivesTheTraceThatWasRecorded) {
  const Eventful session;
  const auto file = SessionFile::open(session.path);
  ASSERT_TRUE(file) << file.error().text();
  std::size_t next = 0;
  const auto replay =
      re_solve_session(**file, test::session_library(), -1e9, 1e9, [&](const FrameSnapshot& frame) -> Status {
        const FrameSnapshot& recorded = *session.keeper->frames.at(next++);
        EXPECT_EQ(frame.index, recorded.index);
        EXPECT_EQ(trace_line(frame), trace_line(recorded)) << "frame " << recorded.index;
        return Done{};
      });
  ASSERT_TRUE(replay) << replay.error().text();
  EXPECT_EQ(next, session.keeper->frames.size());
  EXPECT_EQ(replay->frames, session.keeper->frames.size());
  EXPECT_EQ(replay->differ, 0U);
  EXPECT_EQ(replay->skipped, 0U);
}

TEST(SessionReplay, ARangeInTheMiddleHasTheSameBits) {
  const Eventful session;
  const auto file = SessionFile::open(session.path);
  std::uint64_t frames = 0;
  const auto replay =
      re_solve_session(**file, test::session_library(), 1.6, 2.4, [&](const FrameSnapshot& frame) -> Status {
        EXPECT_EQ(trace_line(frame), trace_line(*session.keeper->frames.at(frame.index)));
        ++frames;
        return Done{};
      });
  ASSERT_TRUE(replay);
  EXPECT_GT(frames, 30U);
  EXPECT_EQ(replay->differ, 0U);
}

TEST(SessionReplay, NeedsTheLibraryThatItWasRecordedWith) {
  const Eventful session;
  const auto file = SessionFile::open(session.path);
  LibraryColumns columns = test::session_library()->columns();
  columns.poses[5](3, 1) += 1e-6;
  const auto other = std::make_shared<const MotionLibrary>(std::move(columns));
  const auto replay = re_solve_session(**file, other, -1e9, 1e9, [](const FrameSnapshot&) { return Done{}; });
  ASSERT_FALSE(replay);
  EXPECT_THAT(replay.error().text(), testing::HasSubstr("was recorded with the library"));
}

TEST(SessionReplay, CanBeCancelled) {
  const Eventful session;
  const auto file = SessionFile::open(session.path);
  const auto replay = re_solve_session(
      **file, test::session_library(), -1e9, 1e9, [](const FrameSnapshot&) { return Done{}; },
      [](double, std::string_view) { return false; });
  ASSERT_FALSE(replay);
  EXPECT_THAT(replay.error().text(), testing::HasSubstr("cancelled"));
}

}  // namespace
}  // namespace abrazo::session_replay_test
