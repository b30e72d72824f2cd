#include "core/session/run/comparison.hpp"

#include <gtest/gtest.h>

#include "core/library/build/motion_library_builder.hpp"
#include "core/session/frames/comparison_plan.hpp"
#include "core/session/run/comparison_runner.hpp"
#include "core/session/run/live_loop.hpp"
#include "core/stream/receive/clip_source.hpp"
#include "tests/support/libraries.hpp"
#include "tests/support/settings.hpp"

namespace abrazo::comparison_test {
namespace {

std::shared_ptr<const MotionLibrary> library() {
  static const auto small = test::small_library();
  return small;
}

Settings slow_settings() {
  Settings settings = test::responsive_by_pose();
  settings.velocity_weight = 2;
  settings.place_rate = 2;  // what the place lags behind is most of the lag
  return settings;
}

double value(const RunFigures& figures, RunFigure figure) {
  return figures[static_cast<std::size_t>(figure)];
}

/// Frames on a disk that fails behind the first ones.
class FailingDisk : public FrameStore {
 public:
  FailingDisk(std::vector<FrameSnapshotPtr> frames, std::size_t readable)
      : frames_(std::move(frames)), readable_(readable) {}

  Span span() const override {
    return {frames_.front()->time_s, frames_.back()->time_s, 0, frames_.size() - 1, frames_.size()};
  }
  FrameSnapshotPtr at(double time_s) const override {
    for (std::size_t i = readable_; i-- > 0;)
      if (frames_[i]->time_s <= time_s) return frames_[i];
    return nullptr;
  }
  FrameSnapshotPtr frame(std::uint64_t index) const override {
    return index < readable_ ? frames_.at(index) : nullptr;
  }
  std::vector<FrameSnapshotPtr> range(double, double, std::size_t) const override {
    return between(0, readable_ - 1, FrameHistory::all_frames);
  }
  std::vector<FrameSnapshotPtr> between(std::uint64_t first, std::uint64_t last, std::size_t) const override {
    std::vector<FrameSnapshotPtr> found;
    for (std::uint64_t index = first; index <= last; ++index)
      if (const FrameSnapshotPtr one = frame(index)) found.push_back(one);
    return found;
  }
  std::optional<std::uint64_t> state_before(std::uint64_t) const override { return 0; }

 private:
  std::vector<FrameSnapshotPtr> frames_;
  std::size_t readable_;
};

/// A session recorded by hand, with the settings "responsive".
class Recorded : public testing::Test {
 protected:
  Recorded() {
    auto synthesizer = std::move(*PartnerSynthesizer::create(library(), test::responsive_by_pose()));
    auto source = std::make_unique<ClipSource>(test::swinging_take("user", 900, 4).a);
    loop = std::make_unique<LiveLoop>(std::move(synthesizer), std::move(source), commands, history, latest);
  }
  void run_until(double to_s) {
    while (now_s < to_s) now_s = std::max(loop->turn(now_s), now_s + 1e-6);
  }
  std::shared_ptr<const Comparison> carried_out(const ComparisonTask& task) {
    ComparisonRun run(task, history, solvers);
    while (run.advance(7)) {
    }
    return run.measured();
  }

  CommandQueue commands;
  FrameHistory history;
  LatestSlot<FrameSnapshot> latest;
  std::unique_ptr<LiveLoop> loop;
  double now_s = 0;
  ComparisonRun::Solvers solvers{library(), {}, nullptr, nullptr};
};

TEST_F(Recorded, AFrameIsSolvedAgainWithAPinThatTheLiveSolverDoesNotHave) {
  run_until(3);
  const FrameSnapshotPtr parked = history.at(2);
  const int other = parked->result.candidates.back().pair;
  ASSERT_NE(other, parked->result.candidates[static_cast<std::size_t>(parked->result.selected)].pair);
  CompareSituation now{
      .frozen = {}, .present = parked->settings, .is_aside = false, .playback = {}, .shown = parked};
  now.playback.state = Playback::State::Parked;
  EXPECT_FALSE(what_if_task(now, nullptr)) << "nothing would differ";
  now.tried_pin = other;
  const auto task = what_if_task(now, nullptr);
  ASSERT_TRUE(task);
  const auto result = carried_out(*task);
  ASSERT_TRUE(result->trouble.empty()) << result->trouble;
  const FrameSnapshotPtr pinned = result->b->at(2);
  EXPECT_EQ(pinned->result.candidates[static_cast<std::size_t>(pinned->result.selected)].pair, other);
  EXPECT_EQ(pinned->decisions->pinned, other);
  EXPECT_NE(pinned->result.result, parked->result.result);
  EXPECT_EQ(history.at(2), parked) << "the recorded frame stays what it was";
  EXPECT_FALSE(latest.newest()->decisions) << "the live solver is not told";
  now.tried_pin = parked->result.candidates.front().pair;
  EXPECT_NE(what_if_task(now, &*task), task) << "another pin is another what-if";
}

/// A take that joins the library of a running session, or leaves it, makes another library.
TEST_F(Recorded, FramesOfALibraryWithMorePairsAreNotLookedUpInOneWithFewer) {
  run_until(3);
  std::vector<PairedTake> takes;
  takes.push_back(test::swinging_take("first", 12, 1));
  auto less = build_library("less", std::move(takes), {}, {});
  ASSERT_TRUE(less);
  solvers.library = std::make_shared<const MotionLibrary>(std::move(*less));
  for (const bool with_recorded : {true, false}) {
    const auto settings_a = with_recorded ? std::nullopt : std::optional(test::responsive_by_pose());
    const auto result = carried_out({settings_a, slow_settings(), 1, 2, false});
    EXPECT_TRUE(result->done);
    EXPECT_EQ(result->trouble, "these frames were solved with another library");
    EXPECT_TRUE(result->steps.empty());
  }
}

TEST_F(Recorded, TwoRunsAreSolvedOverTheSameFrames) {
  run_until(3);
  const auto result = carried_out({slow_settings(), test::responsive_by_pose(), 1, 2, false});
  EXPECT_TRUE(result->done);
  EXPECT_EQ(result->fraction, 1);
  EXPECT_EQ(result->steps.size(), history.range(1, 2).size());
  EXPECT_EQ(result->a->span().frames, result->b->span().frames);
  EXPECT_EQ(result->settings_a, slow_settings());
  EXPECT_GT(value(result->figures_a, RunFigure::BehindSelected),
            value(result->figures_b, RunFigure::BehindSelected));
  EXPECT_GT(result->steps.back().b[static_cast<std::size_t>(StepFigure::PartnerDistance)], 0.001);
}

TEST_F(Recorded, ARunWithoutSettingsIsAsRecorded) {
  run_until(2);
  const auto result = carried_out({std::nullopt, test::responsive_by_pose(), 1, 1.5, false});
  for (const ComparedStep& step : result->steps)
    EXPECT_EQ(step.b[static_cast<std::size_t>(StepFigure::PartnerDistance)], 0) << step.time_s;
}

TEST_F(Recorded, AWhatIfOnOneFrameHasOneStep) {
  run_until(2);
  const double here_s = history.at(1.3)->time_s;
  const auto result = carried_out({std::nullopt, slow_settings(), here_s, here_s, false});
  ASSERT_EQ(result->steps.size(), 1U);
  EXPECT_EQ(result->b->at(here_s)->index, history.at(here_s)->index);
}

TEST_F(Recorded, ARunThatGoesOnFollowsTheLiveSolver) {
  run_until(1);
  ComparisonRun run({slow_settings(), std::nullopt, history.span().last_s, 0, true}, history, solvers);
  while (run.advance(8)) {
  }
  const std::size_t before = run.measured()->steps.size();
  EXPECT_EQ(before, 1U);
  run_until(2);
  while (run.advance(8)) {
  }
  EXPECT_FALSE(run.is_done());
  EXPECT_EQ(run.measured()->steps.size(), 61U);
  EXPECT_EQ(run.measured()->a->at(99)->index, latest.newest()->index);
}

TEST_F(Recorded, FiguresOfALiveComparisonAreThoseSinceTheSettingsChanged) {
  run_until(1);
  ComparisonRun run({slow_settings(), std::nullopt, history.span().last_s, 0, true}, history, solvers);
  run_until(2);
  commands.push(SetSettings{*preset("paper")});
  run_until(2.5);
  while (run.advance(8)) {
  }
  const auto result = run.measured();
  EXPECT_EQ(result->settings_b, *preset("paper"));
  EXPECT_GE(result->steps.front().time_s, 2 - 1e-9);
}

TEST_F(Recorded, FramesThatAreGoneAreSaidToBeGone) {
  run_until(1);
  const auto result = carried_out({std::nullopt, slow_settings(), 50, 60, false});
  EXPECT_TRUE(result->done);
  EXPECT_NE(result->trouble.find("no longer kept"), std::string::npos);
}

TEST_F(Recorded, ARunEndsWhereItsFramesCannotBeReadAndCountsThem) {
  run_until(2);
  const auto frames = history.since(0);
  FrameHistory on_disk;
  on_disk.set_store(std::make_shared<FailingDisk>(frames, 50));
  ComparisonRun run({std::nullopt, slow_settings(), 0, 2, false}, on_disk, solvers);
  for (int turn = 0; turn < 100; ++turn) run.advance(7);
  EXPECT_TRUE(run.is_done());
  const auto result = run.measured();
  EXPECT_EQ(result->steps.size(), 50U) << "what could be read is compared";
  EXPECT_EQ(result->unread, frames.size() - 50);
  EXPECT_EQ(carried_out({std::nullopt, slow_settings(), 0, 2, false})->unread, 0U);
}

TEST_F(Recorded, ARunThatFellBehindStartsAnewAtTheLiveEnd) {
  run_until(1);
  ComparisonRun run({slow_settings(), std::nullopt, history.span().last_s, 0, true}, history, solvers);
  run.advance(1);
  run_until(12.5);  // 690 frames without a turn
  while (run.advance(8)) {
  }
  EXPECT_EQ(run.measured()->a->at(99)->index, latest.newest()->index);
  EXPECT_LT(run.measured()->steps.size(), 60U);
  EXPECT_GT(run.measured()->a->span().first_s, 1.1) << "what was solved before the gap is gone";
}

TEST_F(Recorded, AnUnknownExcludedTakeIsTrouble) {
  run_until(1);
  solvers.excluded_takes = {"nobody"};
  EXPECT_NE(carried_out({std::nullopt, slow_settings(), 0, 1, false})->trouble.find("nobody"),
            std::string::npos);
}

TEST_F(Recorded, TheLatestTaskWinsAndACancelledOnePublishesNothing) {
  run_until(10);
  ComparisonRunner runner(library(), {}, history);
  std::uint64_t seen = 0;
  runner.ask({std::nullopt, slow_settings(), 0, 10, false});
  const ComparisonTask wanted{std::nullopt, slow_settings(), 9, 9.1, false};
  runner.ask(wanted);
  std::shared_ptr<const Comparison> result;
  while (!result || result->task != wanted || !result->done) {
    if (auto newer = runner.take_if_newer(seen)) result = std::move(newer);
    std::this_thread::yield();
  }
  EXPECT_EQ(result->steps.size(), history.range(9, 9.1).size());
  runner.ask({std::nullopt, slow_settings(), 0, 10, false});
  runner.cancel();
  runner.ask(wanted);  // answered only after what was cancelled has been dropped
  result.reset();
  while (!result || !result->done) {
    if (auto newer = runner.take_if_newer(seen)) result = std::move(newer);
    std::this_thread::yield();
  }
  EXPECT_EQ(result->task, wanted);
}

CompareSituation parked_at(double time_s, const Settings& recorded) {
  CompareSituation now;
  auto frame = std::make_shared<FrameSnapshot>();
  frame->time_s = time_s;
  frame->settings = recorded;
  now.shown = frame;
  now.present = recorded;
  now.playback.state = Playback::State::Parked;
  now.playback.last_s = 60;
  return now;
}

TEST(ComparisonPlan, AParkedCursorIsSolvedAgainOnceASettingDiffers) {
  CompareSituation now = parked_at(20, test::responsive_by_pose());
  EXPECT_FALSE(what_if_task(now, nullptr));
  now.present = slow_settings();
  const auto task = what_if_task(now, nullptr);
  ASSERT_TRUE(task);
  EXPECT_FALSE(task->a);
  EXPECT_EQ(task->b, slow_settings());
  EXPECT_EQ(task->from_s, 18);
  EXPECT_EQ(task->to_s, 20);
}

TEST(ComparisonPlan, AFrozenRunIsSolvedAgainToo) {
  CompareSituation now = parked_at(20, test::responsive_by_pose());
  now.frozen = *preset("paper");
  now.span = WhatIfSpan::Frame;
  const auto task = what_if_task(now, nullptr);
  ASSERT_TRUE(task);
  EXPECT_EQ(task->a, *preset("paper"));
  EXPECT_EQ(task->from_s, task->to_s);
  now.present = *preset("paper");
  EXPECT_FALSE(what_if_task(now, nullptr)) << "A and B would be the same run";
}

TEST(ComparisonPlan, ACursorInsideWhatIsSolvedAsksForNothingNew) {
  CompareSituation now = parked_at(20, test::responsive_by_pose());
  now.present = slow_settings();
  const auto task = what_if_task(now, nullptr);
  CompareSituation earlier = parked_at(19, test::responsive_by_pose());
  earlier.present = slow_settings();
  EXPECT_EQ(what_if_task(earlier, &*task), task);
  CompareSituation outside = parked_at(21, test::responsive_by_pose());
  outside.present = slow_settings();
  EXPECT_NE(what_if_task(outside, &*task), task);
  CompareSituation frozen = earlier;
  frozen.frozen = *preset("paper");
  ASSERT_TRUE(what_if_task(frozen, &*task));
  EXPECT_EQ(what_if_task(frozen, &*task)->a, *preset("paper")) << "the other side is another run";
}

TEST(ComparisonPlan, ARangeNeedsItsMarks) {
  CompareSituation now = parked_at(20, test::responsive_by_pose());
  now.present = slow_settings();
  now.span = WhatIfSpan::InToOut;
  EXPECT_FALSE(what_if_task(now, nullptr));
  now.playback.in_s = 5;
  now.playback.out_s = 9;
  EXPECT_EQ(what_if_task(now, nullptr)->from_s, 5);
  EXPECT_EQ(what_if_task(now, nullptr)->to_s, 9);
}

TEST(ComparisonPlan, WhileFollowingTheShadowIsTheRunThatLiveDoesNotSolve) {
  CompareSituation now = parked_at(20, test::responsive_by_pose());
  now.playback.state = Playback::State::Following;
  EXPECT_FALSE(what_if_task(now, nullptr));
  EXPECT_FALSE(shadow_task(now, 20));
  now.frozen = *preset("paper");
  now.present = slow_settings();
  EXPECT_EQ(shadow_task(now, 20)->a, *preset("paper"));
  EXPECT_FALSE(shadow_task(now, 20)->b);
  now.is_aside = true;
  EXPECT_FALSE(shadow_task(now, 20)->a);
  EXPECT_EQ(shadow_task(now, 20)->b, slow_settings());
  EXPECT_TRUE(shadow_task(now, 20)->follows_live);
}

}  // namespace
}  // namespace abrazo::comparison_test
