#include <gtest/gtest.h>

#include <algorithm>

#include "core/library/build/motion_library_builder.hpp"
#include "core/session/run/live_loop.hpp"
#include "core/session/run/solver_thread.hpp"
#include "core/stream/receive/clip_source.hpp"
#include "core/synthesis/step/synthesizer_state.hpp"
#include "tests/core/session/fakes.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/settings.hpp"

namespace abrazo::live_commands_test {
namespace {

using test::FakeDevice;
using test::FakeListener;
using test::FakeSink;

constexpr double frame_s = 1.0 / 60;

std::shared_ptr<const MotionLibrary> small_library_reordered() {
  std::vector<PairedTake> takes;
  takes.push_back(test::swinging_take("second", 150, 2));
  takes.push_back(test::swinging_take("first", 180, 1));
  return std::make_shared<const MotionLibrary>(
      std::move(*build_library("reordered", std::move(takes), {}, {})));
}

/// Two people of whom the second is a tenth taller.
std::shared_ptr<const MotionLibrary> library_of_two_sizes() {
  PairedTake take = test::swinging_take("first", 180, 1);
  for (Pose& pose : take.b.poses) pose *= 1.1;
  std::vector<PairedTake> takes;
  takes.push_back(std::move(take));
  return std::make_shared<const MotionLibrary>(
      std::move(*build_library("two sizes", std::move(takes), {}, {})));
}

/// A device that cannot be told a rate while it is jammed.
class JammedDevice : public FakeDevice {
 public:
  void set_max_rate(double) override {
    if (is_jammed) throw std::runtime_error("the device is jammed");
  }
  bool is_jammed = false;
};

/// A live loop on a device; the test hands in the poses and says what time it is.
class LiveCommands : public testing::Test {
 protected:
  /// By pose: what is told of candidates does not depend on when the library has been learned.
  static std::shared_ptr<PartnerSynthesizer> synthesizer() {
    return std::move(*PartnerSynthesizer::create(test::small_library(), test::responsive_by_pose()));
  }
  SourcePose next_pose() {
    SourcePose pose;
    pose.pose = user.poses[poses_sent++ % user.poses.size()];
    pose.time_s = now_s;
    pose.arrived_s = now_s - 0.004;
    pose.assembled_s = now_s - 0.003;
    return pose;
  }
  /// So many poses, 60 a second.
  void dance(int frames) {
    for (int i = 0; i < frames; ++i) {
      device->arrive(next_pose());
      loop->turn(now_s);
      now_s += frame_s;
    }
  }
  /// Nothing comes for a while; the loop is asked every 5 ms.
  void wait(double seconds) {
    for (const double until_s = now_s + seconds; now_s < until_s; now_s += 0.005) loop->turn(now_s);
  }
  const FrameSnapshot& newest() const { return *latest.newest(); }
  int newest_pair() const {
    const FrameResult& result = newest().result;
    return result.candidates[static_cast<std::size_t>(result.selected)].pair;
  }
  void intend(std::optional<std::string> label, double until_s = -1, bool until_done = false) {
    IntendedMove move;
    move.label = std::move(label);
    move.until_s = until_s;
    move.until_done = until_done;
    commands.push(IntendMove{move});
  }

  Clip user = test::swinging_take("user", 240, 4).a;
  std::size_t poses_sent = 0;
  double now_s = 5;
  CommandQueue commands;
  FrameHistory history;
  LatestSlot<FrameSnapshot> latest;
  std::shared_ptr<FakeDevice> device = std::make_shared<FakeDevice>();
  double clock_s = 0;  ///< what the loop reads when it looks at the clock itself
  std::unique_ptr<LiveLoop> loop = std::make_unique<LiveLoop>(synthesizer(), device, commands, history,
                                                              latest, [this] { return clock_s += 0.001; });
};

TEST_F(LiveCommands, AFrameSaysWhereItsTimeWent) {
  clock_s = 7;
  commands.push(AttachSink{Character::Partner, std::make_shared<FakeSink>()});
  dance(1);
  const FrameTimes& times = newest().times;
  EXPECT_DOUBLE_EQ(times.arrived_s, 5 - 0.004);
  EXPECT_DOUBLE_EQ(times.assembled_s, 5 - 0.003);
  EXPECT_DOUBLE_EQ(times.taken_s, 5);
  EXPECT_DOUBLE_EQ(times.solved_s, 7.001);
  EXPECT_DOUBLE_EQ(times.sent_s, 7.002);
}

TEST_F(LiveCommands, WithoutASinkNothingIsSent) {
  dance(1);
  EXPECT_EQ(newest().times.sent_s, -1);
}

TEST_F(LiveCommands, SinksGetTheCharacterTheyWereAttachedFor) {
  const auto partner = std::make_shared<FakeSink>(), user_sink = std::make_shared<FakeSink>();
  commands.push(AttachSink{Character::Partner, partner});
  commands.push(AttachSink{Character::User, user_sink});
  dance(2);
  EXPECT_EQ(partner->sent().back().pose, Pose(newest().result.passive()));
  EXPECT_EQ(user_sink->sent().back().pose, Pose(newest().result.active()));
  EXPECT_TRUE(partner->sent().back().tracked);
  Settings passive = test::responsive_by_pose();
  passive.user_role = UserRole::Passive;
  commands.push(SetSettings{passive});
  dance(1);
  EXPECT_EQ(partner->sent().back().pose, Pose(newest().result.active()));
  EXPECT_EQ(user_sink->sent().back().pose, Pose(newest().result.passive()));
  commands.push(DetachSink{partner});
  dance(1);
  EXPECT_EQ(partner->sent().size(), 3U);
  EXPECT_EQ(user_sink->sent().size(), 4U);
}

TEST_F(LiveCommands, ACommandThatFailsKeepsNothingElseFromBeingDone) {
  const auto jammed = std::make_shared<JammedDevice>();
  commands.push(ReplaceSource{jammed});
  loop->turn(now_s);
  jammed->is_jammed = true;
  const auto sink = std::make_shared<FakeSink>();
  commands.push(PinPair{33});
  commands.push(SetSettings{*preset("paper")});
  commands.push(SetVetoes{{{}, {"second"}, {}}});
  commands.push(SetSettings{test::responsive_by_pose()});
  commands.push(AttachSink{Character::Partner, sink});
  jammed->arrive(next_pose());
  try {
    loop->turn(now_s);
    FAIL() << "it says what could not be done";
  } catch (const std::exception& failure) {
    EXPECT_STREQ(failure.what(), "the device is jammed; the device is jammed");
  }
  ASSERT_TRUE(latest.newest()) << "the pose that was due is solved";
  EXPECT_EQ(newest_pair(), 33);
  EXPECT_EQ(newest().decisions->vetoes.takes, std::set<std::string>{"second"});
  EXPECT_EQ(sink->sent().size(), 1U);
  EXPECT_TRUE(newest().before) << "from there on frames can be solved again";
  jammed->arrive(next_pose());
  EXPECT_NO_THROW(loop->turn(now_s + frame_s)) << "it is said once";
}

TEST_F(LiveCommands, SinksAreToldTheBonesOfTheRoleThatTheirCharacterHas) {
  const auto library = library_of_two_sizes();
  commands.push(
      ReplaceSynthesizer{std::move(*PartnerSynthesizer::create(library, test::responsive_by_pose()))});
  const auto partner = std::make_shared<FakeSink>(), user_sink = std::make_shared<FakeSink>();
  commands.push(AttachSink{Character::Partner, partner});
  commands.push(AttachSink{Character::User, user_sink});
  dance(3);
  const double smaller_m = library->usual_active_body().body.height();
  const double taller_m = library->usual_passive_body().body.height();
  ASSERT_GT(taller_m, smaller_m + 0.01);
  ASSERT_EQ(partner->bodies().size(), 1U) << "once, and again when they change";
  EXPECT_EQ(partner->bodies().back().height(), taller_m);
  EXPECT_EQ(user_sink->bodies().back().height(), smaller_m);
  Settings passive = test::responsive_by_pose();
  passive.user_role = UserRole::Passive;
  commands.push(SetSettings{passive});
  dance(2);
  ASSERT_EQ(partner->bodies().size(), 2U);
  EXPECT_EQ(partner->bodies().back().height(), smaller_m);
  EXPECT_EQ(user_sink->bodies().back().height(), taller_m);
  const auto later = std::make_shared<FakeSink>();
  commands.push(AttachSink{Character::Partner, later});
  commands.push(ReplaceSynthesizer{synthesizer()});
  dance(1);
  EXPECT_EQ(later->bodies().back().height(), test::small_library()->usual_active_body().body.height());
  EXPECT_EQ(partner->bodies().size(), 2U) << "another library, whose performer has the same bones";
}

TEST_F(LiveCommands, SinksAreToldTheBonesOfTheChosenBodies) {
  const auto partner = std::make_shared<FakeSink>(), user_sink = std::make_shared<FakeSink>();
  commands.push(AttachSink{Character::Partner, partner});
  commands.push(AttachSink{Character::User, user_sink});
  dance(2);
  Settings chosen = test::responsive_by_pose();
  ASSERT_TRUE(set_setting(chosen, "active-body", "scale:1.2"));
  ASSERT_TRUE(set_setting(chosen, "passive-body", "scale:0.85"));
  commands.push(SetSettings{chosen});
  dance(2);
  const auto library = newest().library;
  ASSERT_EQ(partner->bodies().size(), 2U);
  EXPECT_NEAR(user_sink->bodies().back().height(), 1.2 * library->usual_active_body().body.height(), 1e-9);
  EXPECT_NEAR(partner->bodies().back().height(), 0.85 * library->usual_passive_body().body.height(), 1e-9);
}

TEST_F(LiveCommands, TheFirstFrameAListenerGetsHasTheStateBefore) {
  dance(5);
  const auto listener = std::make_shared<FakeListener>();
  commands.push(AttachListener{listener});
  dance(4);
  ASSERT_EQ(listener->frames().size(), 4U);
  EXPECT_TRUE(listener->frames().front()->before);
  EXPECT_EQ(listener->frames().front()->index, 5U);
  commands.push(DetachListener{listener});
  dance(2);
  EXPECT_EQ(listener->frames().size(), 4U);
}

TEST_F(LiveCommands, LostTrackingHoldsThePartnerTellsTheSinksAndLeavesOneFrame) {
  const auto sink = std::make_shared<FakeSink>();
  commands.push(AttachSink{Character::Partner, sink});
  dance(10);
  const PairPose held = newest().result.result;
  wait(2);
  EXPECT_EQ(history.since(0).size(), 11U);
  EXPECT_EQ(newest().result.status, StepStatus::Failed);
  EXPECT_EQ(newest().result.result, held);
  const auto sent = sink->sent();
  ASSERT_GT(sent.size(), 20U);
  EXPECT_LT(sent.size(), 32U);
  EXPECT_TRUE(sent[9].tracked);
  EXPECT_FALSE(sent[10].tracked);
  EXPECT_EQ(sent.back().pose, Pose(held.bottomRows<joint_count>()));
  dance(1);
  EXPECT_EQ(newest().result.status, StepStatus::Ok);
  EXPECT_TRUE(sink->sent().back().tracked);
}

TEST_F(LiveCommands, BeforeTheFirstPoseThereIsNothingToHold) {
  const auto sink = std::make_shared<FakeSink>();
  commands.push(AttachSink{Character::Partner, sink});
  wait(2);
  EXPECT_TRUE(history.since(0).empty());
  EXPECT_TRUE(sink->sent().empty());
  EXPECT_GT(loop->turn(now_s), now_s) << "the thread sleeps";
}

TEST_F(LiveCommands, AnotherSourceIsAnotherUserWhoStartsAnew) {
  dance(10);
  const auto other = std::make_shared<FakeDevice>();
  Body body = body_of(std::span(user.poses));
  for (double& length : body.bone_lengths) length *= 1.1;
  other->measure(body);
  commands.push(ReplaceSource{other});
  other->arrive(next_pose());
  loop->turn(now_s);
  ASSERT_TRUE(newest().before);
  EXPECT_EQ(newest().before->memory.frames_since_reset, 0);
  EXPECT_EQ(newest().before->user_body->bone_lengths, body.bone_lengths);
  EXPECT_EQ(newest().index, 10U);
  // What still comes from the first one is nobody's.
  device->arrive(next_pose());
  loop->turn(now_s + frame_s);
  EXPECT_EQ(newest().index, 10U);
}

TEST_F(LiveCommands, FramesHaveTheNameOfTheirSourceAlsoWhenItGivesNoPose) {
  dance(1);
  EXPECT_EQ(newest().input, nullptr);
  const auto name = std::make_shared<const std::string>("vmc://127.0.0.1:39539");
  commands.push(ReplaceSource{std::make_shared<FakeDevice>(), name});
  wait(0.5);
  EXPECT_EQ(newest().result.status, StepStatus::Failed);
  EXPECT_EQ(newest().input, name);
}

TEST_F(LiveCommands, MeasuresThatASourceLearnsLaterAreTakenOver) {
  dance(3);
  Body body = body_of(std::span(user.poses));
  body.bone_lengths[3] *= 1.02;
  device->measure(body);
  dance(1);
  ASSERT_TRUE(newest().before);
  EXPECT_EQ(newest().before->user_body->bone_lengths, body.bone_lengths);
}

TEST_F(LiveCommands, OnlyTheIntendedMoveIsSelectedUntilItIsTakenBack) {
  const auto library = test::small_library();
  intend("turn");
  dance(30);
  for (const auto& frame : history.since(0)) {
    ASSERT_TRUE(frame->decisions);
    EXPECT_EQ(frame->decisions->meant->label, "turn");
    for (const Candidate& candidate : frame->result.candidates)
      EXPECT_EQ(library->label(candidate.pair), "turn");
  }
  commands.push(IntendMove{});
  dance(1);
  EXPECT_FALSE(newest().decisions);
}

TEST_F(LiveCommands, AMoveIsIntendedUntilItsTime) {
  intend("turn", now_s + 0.25);
  dance(30);
  const auto frames = history.since(0);
  for (const auto& frame : frames)
    EXPECT_EQ(frame->decisions != nullptr, frame->time_s < 5.25) << frame->time_s;
  const auto first_without =
      std::find_if(frames.begin(), frames.end(), [](const auto& frame) { return !frame->decisions; });
  ASSERT_NE(first_without, frames.end());
  EXPECT_TRUE((*first_without)->before) << "from there on frames can be solved again";
}

TEST_F(LiveCommands, AMoveThatIsVetoedAltogetherIsAsIfItWereNotMeant) {
  intend("turn");
  commands.push(SetVetoes{{{}, {}, {"turn"}}});
  dance(5);
  EXPECT_EQ(newest().result.status, StepStatus::Ok);
  EXPECT_EQ(test::small_library()->label(newest_pair()), "open_hold");
}

TEST_F(LiveCommands, AMoveThatWasFollowedToItsEndIsDone) {
  const auto library = test::small_library();
  // The user dances the recorded take, so that it is followed frame by frame.
  user = test::swinging_take("first", 180, 1).a;
  const std::string label(library->label(library->find_pair("first", 0, false)));
  int end = 0;
  while (library->label(library->find_pair("first", end, false)) == label) ++end;
  intend(label, -1, true);
  dance(end - 5);
  ASSERT_TRUE(newest().decisions);
  dance(10);
  EXPECT_FALSE(newest().decisions);
}

TEST_F(LiveCommands, AnotherLibraryKeepsSettingsAndTheDecisionsThatItKnows) {
  Settings settings = *preset("paper");
  settings.neighbours = 7;
  commands.push(SetSettings{settings});
  commands.push(SetVetoes{{{3}, {"first", "nowhere"}, {}}});
  commands.push(PinPair{40});
  dance(5);
  const auto before = std::make_shared<FrameSnapshot>(newest());
  // The same takes in another order.
  const auto reordered = small_library_reordered();
  commands.push(
      ReplaceSynthesizer{std::move(*PartnerSynthesizer::create(reordered, test::responsive_by_pose()))});
  dance(1);
  EXPECT_EQ(newest().library, reordered);
  EXPECT_EQ(newest().settings, settings);
  EXPECT_EQ(newest().decisions->vetoes.takes, std::set<std::string>{"first"});
  const auto there = [&](int pair) {
    const auto old = test::small_library();
    return reordered->find_pair(old->take_of(pair).name, static_cast<int>(old->source(pair).frame), false);
  };
  EXPECT_EQ(newest().decisions->pinned, there(40));
  EXPECT_EQ(newest().decisions->vetoes.pairs, std::set<int>{there(3)});
  EXPECT_LT((newest().result.result - before->result.result).rowwise().norm().maxCoeff(), 0.05)
      << "both bodies go on";
}

TEST(SolverThreadWakes, ForACommandAndForAPoseAtOnce) {
  CommandQueue commands;
  FrameHistory history;
  LatestSlot<FrameSnapshot> latest;
  auto device = std::make_shared<FakeDevice>();
  auto loop = std::make_unique<LiveLoop>(
      std::move(*PartnerSynthesizer::create(test::small_library(), *preset("paper"))), device, commands,
      history, latest);
  const std::shared_ptr<WakeUp> wake_up = loop->wake_up();
  loop->turn(0);
  const auto long_ago = std::chrono::steady_clock::now() - std::chrono::hours(1);
  EXPECT_FALSE(wake_up->wait_until(long_ago));
  commands.push(ResetSolver{});
  EXPECT_TRUE(wake_up->wait_until(long_ago));
  SourcePose pose;
  pose.pose = test::standing_pose();
  device->arrive(pose);
  EXPECT_TRUE(wake_up->wait_until(long_ago));
}

}  // namespace
}  // namespace abrazo::live_commands_test
