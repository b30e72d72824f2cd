// A clip as a finite document: solved once over its length, whenever that is, and again after a change.

#include <gtest/gtest.h>

#include "core/session/run/live_loop.hpp"
#include "core/stream/receive/silent_source.hpp"
#include "core/stream/receive/whole_clip.hpp"
#include "tests/core/session/fakes.hpp"
#include "tests/support/libraries.hpp"
#include "tests/support/settings.hpp"

namespace abrazo::clip_solved_once_test {
namespace {

constexpr std::size_t frames_of_clip = 200;

Clip user_clip() {
  return test::swinging_take("user", frames_of_clip, 4).a;
}

struct Solving {
  CommandQueue commands;
  FrameHistory history;
  LatestSlot<FrameSnapshot> latest;
  LiveLoop loop;

  explicit Solving(const Settings& settings)
      : loop(std::move(*PartnerSynthesizer::create(test::small_library(), settings)),
             std::make_unique<WholeClip>(user_clip()), commands, history, latest) {}

  /// All of it, at one moment of the session. @return the turns that it took
  int finish(double now_s = 5) {
    int turns = 0;
    do {
      loop.turn(now_s);
      ++turns;
    } while (!loop.clip_progress()->is_whole() && turns < 10'000);
    return turns;
  }
  std::vector<FrameSnapshotPtr> frames() const { return history.since(0); }
};

/// What a synthesizer of its own answers to the same clip.
std::vector<FrameResult> answers(const Settings& settings, std::optional<int> pinned = {}) {
  const auto synthesizer = std::move(*PartnerSynthesizer::create(test::small_library(), settings));
  const Clip clip = user_clip();
  synthesizer->set_user_body(body_of(clip.poses));
  synthesizer->pin_pair(pinned);
  std::vector<FrameResult> results;
  for (const Pose& pose : clip.poses)
    results.push_back(synthesizer->step(pose, Duration(results.empty() ? 0 : 1 / clip.fps)));
  return results;
}

void expect_same(const std::vector<FrameSnapshotPtr>& frames, const std::vector<FrameResult>& expected) {
  ASSERT_EQ(frames.size(), expected.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    ASSERT_EQ(Pose(frames[i]->result.active()), Pose(expected[i].active())) << "frame " << i;
    ASSERT_EQ(Pose(frames[i]->result.passive()), Pose(expected[i].passive())) << "frame " << i;
    ASSERT_EQ(frames[i]->result.selected, expected[i].selected) << "frame " << i;
  }
}

TEST(ClipSolvedOnce, ItsFramesHaveTheClipsNumbersAndTimesWhateverTheClockOfTheSession) {
  Solving solving(test::responsive_by_pose());
  solving.finish(1234.5);
  const auto frames = solving.frames();
  ASSERT_EQ(frames.size(), frames_of_clip);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i]->index, i);
    EXPECT_EQ(frames[i]->input_frame, static_cast<std::int64_t>(i));
    EXPECT_DOUBLE_EQ(frames[i]->time_s, static_cast<double>(i) / user_clip().fps);
  }
}

TEST(ClipSolvedOnce, IsToTheBitWhatASynthesizerAnswersFrameByFrame) {
  Solving solving(test::responsive_by_pose());
  solving.finish();
  expect_same(solving.frames(), answers(test::responsive_by_pose()));
}

TEST(ClipSolvedOnce, MakesNothingMoreAfterTheLastFrameAndAsksForNoTurn) {
  Solving solving(test::responsive_by_pose());
  solving.finish();
  for (const double now_s : {6.0, 60.0, 600.0})
    EXPECT_TRUE(std::isinf(solving.loop.turn(now_s))) << "nothing is due until a command comes";
  EXPECT_EQ(solving.history.span().frames, frames_of_clip);
  EXPECT_NE(solving.latest.newest()->result.status, StepStatus::Failed) << "the user of a clip is never lost";
}

TEST(ClipSolvedOnce, ASettingThatChangesSolvesAllOfItAgainInPlace) {
  Solving solving(test::responsive_by_pose());
  solving.finish();
  Settings other = test::responsive_by_pose();
  other.alpha = 0.9;
  solving.commands.push(SetSettings{other});
  solving.finish(7);
  EXPECT_EQ(solving.history.span().frames, frames_of_clip) << "no frame was added";
  for (const FrameSnapshotPtr& frame : solving.frames()) EXPECT_EQ(frame->settings, other);
  expect_same(solving.frames(), answers(other));
}

TEST(ClipSolvedOnce, APinCountsFromTheFirstFrame) {
  Solving solving(test::responsive_by_pose());
  solving.finish();
  solving.commands.push(PinPair{17});
  solving.finish();
  expect_same(solving.frames(), answers(test::responsive_by_pose(), 17));
}

TEST(ClipSolvedOnce, WhatIsSeenIsSolvedFirst) {
  Solving solving(test::responsive_by_pose());
  solving.finish();
  constexpr std::uint64_t seen = 150;
  solving.loop.look_at(static_cast<double>(seen) / user_clip().fps + 1e-6);
  Settings other = test::responsive_by_pose();
  other.alpha = 0.9;
  solving.commands.push(SetSettings{other});
  std::uint64_t first = 0;  // that is solved again
  int turns = 0;
  while (solving.frames()[seen]->settings != other && turns < 100) {
    solving.loop.turn(7);
    if (turns++ == 0) first = solving.latest.newest()->index;
  }
  EXPECT_GT(first, seen - 33) << "from the last state before it";
  EXPECT_LE(turns, 33);
  EXPECT_NE(solving.frames()[20]->settings, other);
  solving.finish(7);
  expect_same(solving.frames(), answers(other));
}

TEST(ClipSolvedOnce, AnotherRateLeavesNoFrameOfTheOneBefore) {
  Solving solving(test::responsive_by_pose());
  solving.finish();
  Settings slower = test::responsive_by_pose();
  slower.step_rate_hz = 30;
  solving.commands.push(SetSettings{slower});
  solving.finish();
  const auto frames = solving.frames();
  ASSERT_EQ(frames.size(), frames_of_clip / 2);
  EXPECT_EQ(frames[1]->input_frame, 2) << "the clip's own number";
  EXPECT_EQ(solving.loop.clip_progress()->frames, frames.size());
}

TEST(ClipSolvedOnce, IsNotSentAsIfItWerePerformed) {
  Solving solving(test::responsive_by_pose());
  const auto sink = std::make_shared<test::FakeSink>();
  solving.commands.push(AttachSink{Character::Partner, sink});
  solving.finish();
  solving.loop.turn(60);
  EXPECT_TRUE(sink->sent().empty());
}

TEST(ClipSolvedOnce, AFailureIsToldByTheLastFrameAndAddsNone) {
  Solving solving(test::responsive_by_pose());
  for (int turn = 0; turn < 20; ++turn) solving.loop.turn(5);
  const std::uint64_t last = solving.latest.newest()->index;
  solving.loop.publish_failure("the role stays", 99);
  EXPECT_EQ(solving.latest.newest()->index, last);
  EXPECT_EQ(solving.frames()[last]->result.message, "the role stays");
  solving.finish();
  const auto frames = solving.frames();
  ASSERT_EQ(frames.size(), frames_of_clip);
  for (std::size_t i = 0; i < frames.size(); ++i)
    EXPECT_DOUBLE_EQ(frames[i]->time_s, static_cast<double>(i) / user_clip().fps);
}

TEST(SilentInput, SendsNothingMoreAndMakesNoFrame) {
  CommandQueue commands;
  FrameHistory history;
  LatestSlot<FrameSnapshot> latest;
  const auto device = std::make_shared<test::FakeDevice>();
  LiveLoop loop(std::move(*PartnerSynthesizer::create(test::small_library(), test::responsive_by_pose())),
                std::make_shared<test::SharedDevice>(device), commands, history, latest);
  const auto sink = std::make_shared<test::FakeSink>();
  commands.push(AttachSink{Character::Partner, sink});
  device->arrive({.pose = user_clip().poses[0], .time_s = 1});
  loop.turn(1);
  ASSERT_EQ(sink->sent().size(), 1U);
  commands.push(ReplaceSource{std::make_shared<SilentSource>()});  // disconnected
  for (int i = 0; i < 1000; ++i) loop.turn(1.01 + i * 0.1);
  EXPECT_EQ(sink->sent().size(), 1U) << "after a disconnection the engine hears nothing of the partner";
  EXPECT_EQ(history.span().frames, 1U);
}

}  // namespace
}  // namespace abrazo::clip_solved_once_test
