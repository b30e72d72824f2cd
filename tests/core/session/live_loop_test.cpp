#include "core/session/run/live_loop.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "core/session/run/solver_thread.hpp"
#include "core/stream/receive/clip_source.hpp"
#include "tests/core/session/fakes.hpp"
#include "tests/support/libraries.hpp"
#include "tests/support/settings.hpp"

namespace abrazo::live_loop_test {
namespace {

struct Live {
  CommandQueue commands;
  FrameHistory history;
  LatestSlot<FrameSnapshot> latest;

  std::unique_ptr<LiveLoop> loop(const Settings& settings) {
    auto synthesizer = std::move(*PartnerSynthesizer::create(test::small_library(), settings));
    auto source = std::make_unique<ClipSource>(test::swinging_take("user", 120, 4).a);
    return std::make_unique<LiveLoop>(std::move(synthesizer), std::move(source), commands, history, latest);
  }
};

void run_for(LiveLoop& loop, double from_s, double to_s) {
  for (double now_s = from_s; now_s < to_s;) now_s = std::max(loop.turn(now_s), now_s + 1e-6);
}

TEST(LiveLoop, SolvesEveryPoseOfTheInputAndKeepsEachFrame) {
  Live live;
  const auto loop = live.loop(test::responsive_by_pose());
  run_for(*loop, 0, 1.0 - 1e-3);
  const auto frames = live.history.since(0);
  ASSERT_EQ(frames.size(), 60U);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i]->index, i);
    EXPECT_EQ(frames[i]->input_frame, static_cast<std::int64_t>(i));
    EXPECT_NE(frames[i]->result.status, StepStatus::Failed);
  }
  EXPECT_EQ(live.latest.newest(), frames.back());
  EXPECT_NEAR(frames.back()->input_rate_hz, 60, 0.1);
}

/// A source whose first 1.5 s come late and at once, and whose later poses are in time.
class Backlog : public PoseSource {
 public:
  std::optional<SourcePose> poll(double now_s) override {
    const double due_s = std::max(1.5, static_cast<double>(next_) / 60);
    if (next_ >= 200 || now_s < due_s) return std::nullopt;
    SourcePose pose;
    pose.pose = take_.poses[next_];
    pose.time_s = static_cast<double>(next_++) / 60;
    return pose;
  }
  double next_due_s() const override { return 0; }
  double rate_hz() const override { return 60; }
  void set_max_rate(double) override {}
  std::optional<Body> body() const override { return std::nullopt; }
  void on_arrival(std::function<void()>) override {}

 private:
  Clip take_ = test::swinging_take("user", 200, 4).a;
  std::size_t next_ = 0;
};

TEST(LiveLoop, FramesOfABacklogStandWhereTheyAreSolvedUntilTheSourceHasCaughtUp) {
  Live live;
  LiveLoop loop(std::move(*PartnerSynthesizer::create(test::small_library(), test::responsive_by_pose())),
                std::make_unique<Backlog>(), live.commands, live.history, live.latest);
  constexpr double turn_s = 0.004;
  for (int turn = 0; turn < 500; ++turn) loop.turn(1.5 + turn * turn_s);
  const auto frames = live.history.since(0);
  ASSERT_EQ(frames.size(), 200U);
  for (std::size_t i = 1; i < frames.size(); ++i) {
    EXPECT_GT(frames[i]->time_s - frames[i - 1]->time_s, 0.9 * turn_s) << i;
    EXPECT_NEAR(frames[i]->elapsed_s, 1.0 / 60, 1e-9) << "of the poses, whenever they are solved";
  }
}

TEST(LiveLoop, SettingsActOnTheRunningSolverAndAreRecorded) {
  Live live;
  const auto loop = live.loop(*preset("paper"));
  run_for(*loop, 0, 0.5);
  Settings settings = *preset("paper");
  settings.neighbours = 4;
  settings.step_rate_hz = 30;
  live.commands.push(SetSettings{settings});
  const std::size_t before = live.history.span().frames;
  run_for(*loop, 0.5, 1.5);
  const FrameSnapshotPtr last = live.latest.newest();
  EXPECT_EQ(last->settings, settings);
  EXPECT_EQ(last->result.candidates.size(), 4U);
  EXPECT_NEAR(static_cast<double>(live.history.span().frames - before), 30, 2);
  EXPECT_EQ(live.history.at(0.3)->settings, *preset("paper"));
}

TEST(LiveLoop, AHeldInputMakesNoFramesAndTheLiveEndStays) {
  Live live;
  const auto loop = live.loop(test::responsive_by_pose());
  run_for(*loop, 0, 0.5);
  EXPECT_FALSE(loop->is_held());
  live.commands.push(SetSettings{test::responsive_by_pose()});  // nothing to settle afterwards
  live.commands.push(PauseInput{true});
  run_for(*loop, 0.5, 600);
  EXPECT_TRUE(loop->is_held());
  EXPECT_EQ(live.history.span().frames, 30U);
  EXPECT_LT(live.history.span().last_s, 0.5);
  EXPECT_NE(live.latest.newest()->result.status, StepStatus::Failed) << "a held user is not lost";
}

TEST(LiveLoop, AfterAHoldTheClipGoesOnFromTheHeldPoseAsIfNoTimeHadPassed) {
  Live live;
  const auto loop = live.loop(test::responsive_by_pose());
  run_for(*loop, 0, 0.5);
  const FrameSnapshotPtr last = live.latest.newest();
  live.commands.push(PauseInput{true});
  run_for(*loop, 0.5, 100);
  live.commands.push(PauseInput{false});
  run_for(*loop, 100, 100.5);
  const FrameSnapshotPtr next = live.history.stepped(last->time_s, 1);
  EXPECT_NEAR(next->time_s, 100, 0.05);
  EXPECT_NEAR(static_cast<double>(next->input_frame), static_cast<double>(last->input_frame), 2);
  EXPECT_LT(next->elapsed_s, 0.05) << "no step over the time held";
  EXPECT_EQ(next->dropped_inputs, 0U);
  EXPECT_EQ(live.latest.newest()->dropped_inputs, 0U) << "what was held back was not lost";
  EXPECT_NE(next->result.status, StepStatus::Failed);
}

/// The clip was held for ever when a take was annotated, a stream connected, and the take left.
TEST(LiveLoop, AHoldThatEndsWhileADevicePlaysTheUserIsOverForTheClipAsWell) {
  Live live;
  const auto loop = live.loop(test::responsive_by_pose());
  const auto clip = std::make_shared<ClipSource>(test::swinging_take("user", 120, 4).a);
  live.commands.push(ReplaceSource{clip});
  live.commands.push(PauseInput{true});
  run_for(*loop, 0, 1);
  ASSERT_TRUE(loop->is_held());
  live.commands.push(ReplaceSource{std::make_shared<test::FakeDevice>()});
  loop->turn(1);
  EXPECT_FALSE(loop->is_held()) << "a performer cannot be held";
  live.commands.push(PauseInput{false});
  loop->turn(1.1);
  live.commands.push(ReplaceSource{clip});
  run_for(*loop, 2, 3);
  EXPECT_FALSE(loop->is_held());
  EXPECT_GT(live.latest.newest()->input_frame, 30);
}

/// Runs for half a second and is held until ten. @return the last frame
FrameSnapshotPtr held_from(LiveLoop& loop, Live& live) {
  run_for(loop, 0, 0.5);
  live.commands.push(PauseInput{true});
  run_for(loop, 0.5, 10);
  return live.latest.newest();
}

TEST(LiveLoop, AChangeIsSolvedOnTheHeldPoseAndThenItRestsAgain) {
  Live live;
  const auto loop = live.loop(test::responsive_by_pose());
  const FrameSnapshotPtr held = held_from(*loop, live);
  live.commands.push(SetSettings{*preset("paper")});
  run_for(*loop, 10, 100);
  const FrameSnapshotPtr settled = live.latest.newest();
  EXPECT_EQ(settled->settings, *preset("paper"));
  EXPECT_EQ(settled->user, live.history.at(10.2)->user) << "the pose stays";
  EXPECT_NEAR(static_cast<double>(settled->input_frame), static_cast<double>(held->input_frame), 1);
  EXPECT_EQ(settled->dropped_inputs, 0U);
  EXPECT_NEAR(settled->time_s, 10 + LiveLoop::settling_s, 0.1);
  live.commands.push(AttachListener{nullptr});
  run_for(*loop, 100, 110);
  EXPECT_EQ(live.latest.newest(), settled) << "who listens changes no answer";
}

TEST(LiveLoop, AnotherLibraryMakesNoFrameOfAHeldPoseAndActsOnTheNext) {
  Live live;
  const auto loop = live.loop(test::responsive_by_pose());
  const FrameSnapshotPtr held = held_from(*loop, live);
  const std::shared_ptr<PartnerSynthesizer> next =
      std::move(*PartnerSynthesizer::create(test::two_take_library(), test::responsive_by_pose()));
  live.commands.push(ReplaceSynthesizer{next});
  run_for(*loop, 10, 100);
  EXPECT_EQ(live.latest.newest(), held);
  live.commands.push(PauseInput{false});
  run_for(*loop, 100, 100.5);
  EXPECT_EQ(live.latest.newest()->library, next->shared_library());
}

TEST(LiveLoop, ASessionThatIsHeldFromTheBeginningHasAFrame) {
  Live live;
  const auto loop = live.loop(test::responsive_by_pose());
  live.commands.push(PauseInput{true});
  run_for(*loop, 0, 5);
  EXPECT_EQ(live.history.span().frames, 1U);
}

TEST(LiveLoop, APinnedPairIsTheSourceUntilItIsLetGo) {
  Live live;
  const auto loop = live.loop(*preset("paper"));
  live.commands.push(PinPair{33});
  run_for(*loop, 0, 0.5);
  const FrameResult& pinned = live.latest.newest()->result;
  EXPECT_EQ(pinned.candidates[static_cast<std::size_t>(pinned.selected)].pair, 33);
  live.commands.push(PinPair{std::nullopt});
  run_for(*loop, 0.5, 1.0);
  const FrameResult& free = live.latest.newest()->result;
  EXPECT_EQ(free.candidates.size(), 10U);
}

TEST(LiveLoop, VetoesActBetweenTwoFramesAndOutliveSettings) {
  Live live;
  const auto loop = live.loop(*preset("paper"));
  const auto library = test::small_library();
  run_for(*loop, 0, 0.5);
  live.commands.push(SetVetoes{{{}, {"first"}, {}}});
  live.commands.push(SetSettings{test::responsive_by_pose()});
  run_for(*loop, 0.5, 1.0);
  for (const FrameSnapshotPtr& frame : live.history.range(0.55, 1.0))
    for (const Candidate& candidate : frame->result.candidates)
      EXPECT_EQ(library->take_of(candidate.pair).name, "second");
  live.commands.push(SetVetoes{{{}, {"first", "second"}, {}}});
  run_for(*loop, 1.0, 1.2);
  EXPECT_EQ(live.latest.newest()->result.status, StepStatus::Failed);
  live.commands.push(SetVetoes{});
  run_for(*loop, 1.2, 1.4);
  EXPECT_EQ(live.latest.newest()->result.status, StepStatus::Ok);
}

TEST(LiveLoop, AFailureBecomesASnapshotWithItsText) {
  Live live;
  const auto loop = live.loop(*preset("paper"));
  run_for(*loop, 0, 0.2);
  const PairPose held = live.latest.newest()->result.result;
  loop->publish_failure("out of memory", 0.3);
  EXPECT_EQ(live.latest.newest()->result.status_text(), "failed: out of memory");
  EXPECT_EQ(live.latest.newest()->result.result, held);
}

TEST(LiveLoop, EveryLossOfTheUserIsSaidOnce) {
  Live live;
  const auto device = std::make_shared<test::FakeDevice>();
  LiveLoop loop(std::move(*PartnerSynthesizer::create(test::small_library(), test::responsive_by_pose())),
                device, live.commands, live.history, live.latest);
  const Clip user = test::swinging_take("user", 120, 4).a;
  const auto losses = [&] {
    const auto frames = live.history.since(0);
    return std::count_if(frames.begin(), frames.end(), [](const FrameSnapshotPtr& frame) {
      return frame->result.message == "the user is not tracked; the partner holds its last pose";
    });
  };
  for (int loss = 0; loss < 3; ++loss) {
    for (std::size_t i = 0; i < 60; ++i) {
      const double now_s = 2 * loss + static_cast<double>(i) / 60;
      device->arrive({.pose = user.poses[i], .time_s = now_s});
      loop.turn(now_s);
    }
    EXPECT_NE(live.latest.newest()->result.status, StepStatus::Failed);
    EXPECT_EQ(losses(), loss);
    for (int i = 60; i < 120; ++i) loop.turn(2 * loss + i / 60.0);
    EXPECT_EQ(live.latest.newest()->result.status, StepStatus::Failed);
    EXPECT_EQ(losses(), loss + 1);
  }
}

TEST(SolverThread, PublishesWhileAnotherThreadReadsAndStopsWhenDestroyed) {
  Live live;
  {
    const SolverThread thread(live.loop(test::responsive_by_pose()));
    while (live.history.span().frames < 5) {
      const FrameSnapshotPtr newest = live.latest.newest();
      EXPECT_TRUE(!newest || newest->result.result.allFinite());
      std::this_thread::yield();
    }
    live.commands.push(SetSettings{*preset("paper")});
    while (live.latest.newest()->settings != *preset("paper")) std::this_thread::yield();
  }
  // The thread is gone: every frame it announced is in the history, and none comes after.
  EXPECT_EQ(live.history.at(1e9), live.latest.newest());
  EXPECT_EQ(live.history.since(0).size(), live.latest.newest()->index + 1);
}

}  // namespace
}  // namespace abrazo::live_loop_test
