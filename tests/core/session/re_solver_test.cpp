#include "core/session/run/re_solver.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/session/run/live_loop.hpp"
#include "core/stream/receive/clip_source.hpp"
#include "core/synthesis/frames/trace.hpp"
#include "tests/support/libraries.hpp"
#include "tests/support/settings.hpp"

namespace abrazo::re_solver_test {
namespace {

std::shared_ptr<const MotionLibrary> library() {
  static const auto small = test::small_library();
  return small;
}

/// All that a frame says but for how long it took.
std::string content(const FrameResult& result) {
  FrameResult timeless = result;
  timeless.timing = {};
  return trace_frame_line(timeless, *library(), 0, 0);
}

std::unique_ptr<LiveLoop> responsive_loop(CommandQueue& commands, FrameHistory& history,
                                          LatestSlot<FrameSnapshot>& latest) {
  auto synthesizer = std::move(*PartnerSynthesizer::create(library(), test::responsive_by_pose()));
  auto source = std::make_unique<ClipSource>(test::swinging_take("user", 300, 4).a);
  return std::make_unique<LiveLoop>(std::move(synthesizer), std::move(source), commands, history, latest);
}

std::string last_of_an_undisturbed_run(double to_s) {
  CommandQueue commands;
  FrameHistory history;
  LatestSlot<FrameSnapshot> latest;
  const auto loop = responsive_loop(commands, history, latest);
  for (double now_s = 0; now_s < to_s;) now_s = std::max(loop->turn(now_s), now_s + 1e-6);
  return content(latest.newest()->result);
}

/// A live loop driven by hand, and a second solver beside it.
class Recording : public testing::Test {
 protected:
  void run_until(double to_s) {
    while (now_s < to_s) now_s = std::max(loop->turn(now_s), now_s + 1e-6);
  }

  std::vector<std::shared_ptr<FrameSnapshot>> solved_again(double from_s, double to_s,
                                                           std::optional<Settings> settings = {}) {
    auto found = history.solvable_again(from_s, to_s);
    std::vector<std::shared_ptr<FrameSnapshot>> solved;
    while (const FrameSnapshotPtr frame = found.frames.next()) {
      if (solved.empty()) again->go_to(found.run_up, *frame);
      solved.push_back(again->solve(*frame, settings.value_or(frame->settings)));
    }
    return solved;
  }

  void expect_recorded_bits(double from_s, double to_s) {
    const auto recorded = history.range(from_s, to_s);
    const auto solved = solved_again(from_s, to_s);
    ASSERT_EQ(solved.size(), recorded.size());
    ASSERT_FALSE(solved.empty());
    for (std::size_t i = 0; i < solved.size(); ++i) {
      EXPECT_EQ(solved[i]->index, recorded[i]->index);
      ASSERT_EQ(content(solved[i]->result), content(recorded[i]->result)) << "frame " << recorded[i]->index;
    }
  }

  CommandQueue commands;
  FrameHistory history;
  LatestSlot<FrameSnapshot> latest;
  std::unique_ptr<LiveLoop> loop = responsive_loop(commands, history, latest);
  double now_s = 0;
  std::unique_ptr<ReSolver> again = std::move(*ReSolver::create(library(), {}));
};

TEST_F(Recording, WithTheRecordedSettingsTheBitsAreTheSame) {
  run_until(3);
  expect_recorded_bits(0, 3);
  expect_recorded_bits(1.234, 2.345);  // from a state before the range
  expect_recorded_bits(0.5, 0.9);      // back in time on the same solver
  const double parked_s = history.at(2.0)->time_s;
  expect_recorded_bits(parked_s, parked_s);
}

TEST_F(Recording, CommandsInBetweenAreFollowed) {
  run_until(0.4);
  commands.push(PinPair{33});
  run_until(0.7);
  commands.push(PinPair{std::nullopt});
  commands.push(SetVetoes{{{}, {"first"}, {}}});
  run_until(1.1);
  Settings settings = *preset("paper");
  settings.foot_locks = false;
  commands.push(SetSettings{settings});
  run_until(1.4);
  settings.user_role = UserRole::Passive;
  commands.push(SetSettings{settings});
  run_until(1.8);
  commands.push(ResetSolver{});
  run_until(2.0);
  commands.push(SeekInput{0.3});
  run_until(2.5);
  expect_recorded_bits(0, 2.5);
  expect_recorded_bits(0.6, 1.3);
  expect_recorded_bits(1.7, 2.4);
}

TEST_F(Recording, AStepThatFailedIsFailedAgainAndAFrameWithoutAStepIsPassedOver) {
  run_until(0.5);
  commands.push(SetVetoes{{{}, {"first", "second"}, {}}});
  run_until(0.7);
  commands.push(SetVetoes{});
  run_until(1.0);
  loop->publish_failure("out of memory", 1.0);
  run_until(1.5);
  expect_recorded_bits(0, 1.5);
  expect_recorded_bits(0.6, 1.4);
}

TEST_F(Recording, OtherSettingsGiveAnotherPartnerFromTheSameStart) {
  run_until(2);
  Settings other = test::responsive_by_pose();
  other.velocity_weight = 5;
  other.playback = SourcePlayback::Frames;
  const auto solved = solved_again(1, 1.5, other);
  const auto recorded = history.range(1, 1.5);
  ASSERT_EQ(solved.size(), recorded.size());
  EXPECT_EQ(solved.front()->settings, other);
  EXPECT_GT((solved.back()->result.passive() - recorded.back()->result.passive()).norm(), 1e-3);
  EXPECT_EQ(solved.back()->user, recorded.back()->user);
}

TEST_F(Recording, AWhatIfOnOneFrameIsTheFirstFrameOfAWhatIfOnARange) {
  run_until(2);
  Settings other = *preset("paper");
  const double parked_s = history.at(1.3)->time_s;
  const auto one = solved_again(parked_s, parked_s, other);
  const auto range = solved_again(parked_s, 1.6, other);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(content(one.front()->result), content(range.front()->result));
}

TEST_F(Recording, TheLiveSolverDoesNotNoticeAWhatIf) {
  run_until(1);
  Settings other = *preset("paper");
  other.user_role = UserRole::Passive;
  solved_again(0, 1, other);
  run_until(2);
  const std::string undisturbed = last_of_an_undisturbed_run(2);
  EXPECT_EQ(content(latest.newest()->result), undisturbed);
}

TEST_F(Recording, AfterEvictionARangeBeginsWhereAStateIsKept) {
  run_until(3);
  const auto all = history.since(0);
  std::size_t bytes = 0;
  for (const auto& frame : all) bytes += size_of(*frame);
  FrameHistory shorter(bytes / 2);
  for (const auto& frame : all) shorter.append(frame);
  const FrameHistory::Span span = shorter.span();
  ASSERT_GT(span.evicted, 0U);
  auto found = shorter.solvable_again(0, 3);
  EXPECT_TRUE(found.is_short);
  EXPECT_TRUE(found.run_up.empty());
  const FrameSnapshotPtr first = found.frames.next();
  ASSERT_TRUE(first);
  EXPECT_LT(first->time_s - span.first_s, 0.6);
  again->go_to({}, *first);
  for (FrameSnapshotPtr frame = first; frame; frame = found.frames.next())
    ASSERT_EQ(content(again->solve(*frame, frame->settings)->result), content(frame->result));
}

TEST_F(Recording, ARangeWithoutFramesOrStatesGivesNothing) {
  EXPECT_TRUE(history.solvable_again(0, 1).frames.empty());
  run_until(1);
  EXPECT_TRUE(history.solvable_again(5, 6).frames.empty());
  EXPECT_TRUE(history.solvable_again(0.5, 0.4).frames.empty());
  FrameHistory stateless;
  auto frame = std::make_shared<FrameSnapshot>();
  stateless.append(frame);
  EXPECT_TRUE(stateless.solvable_again(0, 1).frames.empty());
  EXPECT_TRUE(stateless.solvable_again(0, 1).is_short);
  EXPECT_THROW(again->go_to({}, *frame), std::invalid_argument);
}

TEST_F(Recording, StatesAreFewAndCounted) {
  run_until(3);
  std::size_t states = 0;
  const auto frames = history.since(0);
  for (const auto& frame : frames) states += frame->before != nullptr;
  EXPECT_TRUE(frames.front()->before);
  EXPECT_LE(states, frames.size() / 32 + 1);
  auto without = std::make_shared<FrameSnapshot>(*frames.front());
  without->before = nullptr;
  EXPECT_GT(size_of(*frames.front()), size_of(*without) + 4000);
}

}  // namespace
}  // namespace abrazo::re_solver_test
