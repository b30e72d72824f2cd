#include "core/session/run/role_switch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/library/build/motion_library_builder.hpp"
#include "core/session/run/live_loop.hpp"
#include "core/session/run/re_solver.hpp"
#include "core/stream/receive/clip_source.hpp"
#include "core/synthesis/step/synthesizer_state.hpp"
#include "tests/support/libraries.hpp"
#include "tests/support/settings.hpp"

namespace abrazo::role_switch_test {
namespace {

constexpr double frame_s = 1.0 / 60;

/// Both of one size, so that a change of roles is a change of motion and nothing else.
PairedTake equal_take(const std::string& name, int frames, unsigned seed) {
  PairedTake take = test::swinging_take(name, frames, seed);
  for (Pose& pose : take.b.poses) {
    pose.rowwise() -= Vec3(0, 0, 0.7).transpose();
    pose /= 0.93;
    pose.rowwise() += Vec3(0, 0, 0.7).transpose();
  }
  return take;
}

std::shared_ptr<const MotionLibrary> library_of(std::vector<PairedTake> takes) {
  return std::make_shared<const MotionLibrary>(std::move(*build_library("l", std::move(takes), {}, {})));
}

std::shared_ptr<const MotionLibrary> annotated() {
  return library_of({equal_take("first", 180, 1), equal_take("second", 150, 2)});
}

/// One take in which performer A leads for 100 frames, then B.
PairedTake exchanging_take() {
  PairedTake take = equal_take("exchange", 240, 3);
  take.roles = {{0, 100, ActivePerformer::A}, {100, 240, ActivePerformer::B}};
  return take;
}

std::shared_ptr<const RoleViews> views_of(const std::shared_ptr<const MotionLibrary>& library) {
  std::vector<int> pairs;
  for (int pair = 0; pair < library->pair_count(); ++pair) pairs.push_back(pair);
  return std::make_shared<const RoleViews>(library, pairs);
}

struct Live {
  explicit Live(const std::shared_ptr<const MotionLibrary>& library, Clip user,
                const Settings& settings = test::responsive_by_pose())
      : loop(std::move(*PartnerSynthesizer::create(library, settings)),
             std::make_shared<ClipSource>(std::move(user)), commands, history, latest) {}
  void run_until(double to_s) {
    while (now_s < to_s) now_s = std::max(loop.turn(now_s), now_s + 1e-6);
  }
  CommandQueue commands;
  FrameHistory history;
  LatestSlot<FrameSnapshot> latest;
  LiveLoop loop;
  double now_s = 0;
};

Pose partner_of(const FrameSnapshot& frame) {
  return frame.settings.user_role == UserRole::Passive ? Pose(frame.result.active())
                                                       : Pose(frame.result.passive());
}

/// Of the partner's root from each frame to the next [m].
double largest_step(const std::vector<FrameSnapshotPtr>& frames) {
  double largest = 0;
  for (std::size_t i = 1; i < frames.size(); ++i)
    largest =
        std::max(largest, (partner_of(*frames[i]) - partner_of(*frames[i - 1])).rowwise().norm().maxCoeff());
  return largest;
}

TEST(ChangeOfRole, TheUserStaysAndThePartnerJumpsNoMoreThanAtAChangeOfSource) {
  for (const auto name : preset_names) {
    Live changed(annotated(), equal_take("user", 240, 4).a, *preset(name));
    Live cut(annotated(), equal_take("user", 240, 4).a, *preset(name));
    changed.run_until(1);
    cut.run_until(1);
    Settings passive = *preset(name);
    passive.user_role = UserRole::Passive;
    changed.commands.push(SetSettings{passive});
    // The take that is followed may not be any more: a change of source as it happens every day.
    const FrameResult& followed = cut.latest.newest()->result;
    const auto library = annotated();
    const int pair = followed.candidates[static_cast<std::size_t>(followed.selected)].pair;
    cut.commands.push(SetVetoes{{{}, {library->take_of(pair).name}, {}}});
    changed.run_until(1.5);
    cut.run_until(1.5);
    const auto frames = changed.history.range(0.98, 1.3);
    EXPECT_TRUE(std::any_of(frames.begin(), frames.end(), [](const auto& f) {
      return f->result.source_changed && f->settings.user_role == UserRole::Passive;
    }));
    EXPECT_LT(largest_step(frames), 1.5 * largest_step(cut.history.range(0.98, 1.3)) + 0.01) << name;
    for (std::size_t i = 1; i < frames.size(); ++i) {
      const Pose& user = frames[i]->user;
      const Pose shown = frames[i]->settings.user_role == UserRole::Passive
                             ? Pose(frames[i]->result.passive())
                             : Pose(frames[i]->result.active());
      EXPECT_LT((shown.row(0) - user.row(0)).norm(), 0.1) << name << " at " << frames[i]->time_s;
    }
  }
}

TEST(ChangeOfRole, KeepsWhatCameBefore) {
  Live live(annotated(), equal_take("user", 240, 4).a);
  live.run_until(1);
  Settings passive = test::responsive_by_pose();
  passive.user_role = UserRole::Passive;
  live.commands.push(SetSettings{passive});
  live.run_until(1.01);
  const FrameSnapshot& first = *live.latest.newest();
  ASSERT_TRUE(first.before);
  EXPECT_EQ(first.before->user_role, UserRole::Passive);
  EXPECT_GT(first.before->memory.frames_since_reset, 50);
  EXPECT_EQ(first.before->memory.current_pair, -1);
}

TEST(RoleByLibrary, FollowsThePerformerWhomTheUserPlays) {
  const auto library = library_of({exchanging_take()});
  Live live(library, exchanging_take().a);
  live.commands.push(SetRoleControl{RoleControl::Library});
  live.run_until(3.9);
  for (const auto& frame : live.history.range(0, 3.9)) {
    const double away_s = std::abs(frame->time_s - 100 * frame_s);
    if (away_s < 0.2) continue;
    EXPECT_EQ(frame->settings.user_role, frame->input_frame < 100 ? UserRole::Active : UserRole::Passive)
        << frame->input_frame;
  }
}

TEST(RoleByLibrary, OfTheOtherPerformerItIsTheOtherWayRound) {
  const auto library = library_of({exchanging_take()});
  Settings settings = test::responsive_by_pose();
  settings.user_role = UserRole::Passive;
  Live live(library, exchanging_take().b, settings);
  live.commands.push(SetRoleControl{RoleControl::Library});
  live.run_until(3.9);
  EXPECT_EQ(live.history.at(1.2)->settings.user_role, UserRole::Passive);
  EXPECT_EQ(live.history.at(2.5)->settings.user_role, UserRole::Active);
}

TEST(RoleByLibrary, TheHandTakesOverAgain) {
  const auto library = library_of({exchanging_take()});
  Live live(library, exchanging_take().a);
  live.commands.push(SetRoleControl{RoleControl::Library});
  live.run_until(2.5);
  ASSERT_EQ(live.latest.newest()->settings.user_role, UserRole::Passive);
  // The panel's role says active; it counts as soon as the hand decides.
  live.commands.push(SetSettings{test::responsive_by_pose()});
  live.run_until(2.7);
  EXPECT_EQ(live.latest.newest()->settings.user_role, UserRole::Passive);
  live.commands.push(SetRoleControl{RoleControl::Hand});
  live.run_until(2.9);
  EXPECT_EQ(live.latest.newest()->settings.user_role, UserRole::Active);
  EXPECT_FALSE(live.latest.newest()->decisions);
}

TEST(RoleByLibrary, APairThatIsFollowedFromTimeZeroOnHasBeenFollowedSince) {
  const auto library = library_of({exchanging_take()});
  RoleSwitch by_library(views_of(library), UserRole::Active);
  by_library.control(RoleControl::Library, UserRole::Active);
  FrameResult followed;
  followed.candidates.resize(1);
  followed.candidates[0].pair = library->find_pair("exchange", 97, false);  // B leads from frame 100 on
  ASSERT_GE(followed.candidates[0].pair, 0);
  followed.selected = 0;
  const Pose user = Pose::Zero();
  const std::optional<Body> no_body;
  EXPECT_EQ(by_library.after({followed, user, no_body, 0}), UserRole::Active);
  EXPECT_EQ(by_library.after({followed, user, no_body, RoleSwitch::dwell_s}), UserRole::Passive);
}

class RoleByLeader : public testing::Test {
 protected:
  /// The role after a clip was danced, from a role that is wrong.
  UserRole after(const Clip& clip, UserRole before) {
    RoleSwitch by_leader(views, before);
    by_leader.control(RoleControl::Leader, before);
    const std::optional<Body> body = body_of(std::span(clip.poses));
    for (std::size_t i = 0; i < clip.poses.size(); ++i) {
      const UserRole was = by_leader.role();
      by_leader.after({FrameResult(), clip.poses[i], body, static_cast<double>(i) * frame_s});
      if (by_leader.role() != was) changed_s.push_back(static_cast<double>(i) * frame_s);
    }
    return by_leader.role();
  }
  std::shared_ptr<const RoleViews> views = views_of(annotated());
  std::vector<double> changed_s;
};

TEST_F(RoleByLeader, WhoMovesLikeARecordedLeaderLeadsAndTheOtherWayRound) {
  const PairedTake take = equal_take("first", 180, 1);
  EXPECT_EQ(after(take.a, UserRole::Passive), UserRole::Active);
  EXPECT_EQ(after(take.b, UserRole::Active), UserRole::Passive);
  ASSERT_EQ(changed_s.size(), 2U);
  for (const double at_s : changed_s) EXPECT_LT(at_s, RoleSwitch::dwell_s + LeaderJudge::stretch_s);
}

TEST_F(RoleByLeader, IsJudgedFromAWholeStretchWithoutAGap) {
  const Clip clip = equal_take("first", 180, 1).a;
  const Body body = body_of(std::span(clip.poses));
  LeaderJudge judge(views);
  constexpr double begin_s = 10;
  std::size_t i = 0;
  const auto see_until = [&](double to_s, double later_s) {
    for (; static_cast<double>(i) * frame_s < to_s; ++i)
      judge.see(clip.poses[i], body, begin_s + later_s + static_cast<double>(i) * frame_s);
    return judge.fit().active_m >= 0;
  };
  EXPECT_FALSE(see_until(LeaderJudge::stretch_s - 0.1, 0)) << "too short";
  EXPECT_TRUE(see_until(LeaderJudge::stretch_s + 0.1, 0));
  EXPECT_FALSE(see_until(LeaderJudge::stretch_s + 0.2, 0.5)) << "begins anew behind the gap";
}

TEST_F(RoleByLeader, ARoleIsKeptForAWhile) {
  const PairedTake take = equal_take("first", 180, 1);
  after(take.a, UserRole::Passive);
  ASSERT_EQ(changed_s.size(), 1U);
  EXPECT_GE(changed_s.front(), RoleSwitch::dwell_s);
}

TEST_F(RoleByLeader, WhereTimeBeginsAnewARoleIsKeptFromThereOn) {
  const PairedTake take = equal_take("first", 180, 1);
  RoleSwitch by_leader(views, UserRole::Passive);
  by_leader.control(RoleControl::Leader, UserRole::Passive);
  const std::optional<Body> body = body_of(std::span(take.a.poses));
  by_leader.after({FrameResult(), take.a.poses.front(), body, 1000});
  for (std::size_t i = 0; i < take.a.poses.size(); ++i)
    by_leader.after({FrameResult(), take.a.poses[i], body, static_cast<double>(i) * frame_s});
  EXPECT_EQ(by_leader.role(), UserRole::Active);
}

TEST_F(RoleByLeader, WithoutAnnotationNobodyCanTell) {
  PairedTake take = equal_take("first", 180, 1);
  take.roles.clear();
  views = views_of(library_of({take}));
  EXPECT_FALSE(check_role_control(*views, RoleControl::Leader));
  EXPECT_FALSE(check_role_control(*views, RoleControl::Library));
  EXPECT_TRUE(check_role_control(*views, RoleControl::Hand));
  EXPECT_EQ(after(take.a, UserRole::Passive), UserRole::Passive);
}

TEST_F(RoleByLeader, ADistanceIsWhatTheFormulaSays) {
  const PairedTake take = equal_take("first", 180, 1);
  LeaderJudge judge(views);
  const Body body = body_of(std::span(take.a.poses));
  for (int i = 0; i < 120; ++i) judge.see(take.a.poses[static_cast<std::size_t>(i)], body, i * frame_s);
  EXPECT_LT(judge.fit().active_m, 0.02) << "the recorded stretch itself";
  EXPECT_GT(judge.fit().passive_m, 0.05);
  EXPECT_GT(judge.fit().evidence, 0);
}

TEST_F(RoleByLeader, TheStretchBeginsASecondBeforeThePose) {
  Clip clip = equal_take("first", 180, 1).a;
  const Body body = body_of(std::span(clip.poses));
  // Somewhere else until 0.9 s before the end: of the six poses of the stretch only the earliest.
  const std::size_t end = 120, here = end - 54;
  for (std::size_t i = 0; i < here; ++i) clip.poses[i].col(0).array() += 0.6;
  LeaderJudge judge(views);
  for (std::size_t i = 0; i <= end; ++i) judge.see(clip.poses[i], body, static_cast<double>(i) * frame_s);
  EXPECT_NEAR(judge.fit().active_m, 0.6 / std::sqrt(6), 0.03) << "by the formula of the header";
}

TEST(SolvedAgain, WithPinsVetoesMeantMovesAndChangesOfRoleTheBitsAreTheSame) {
  const auto library = library_of({exchanging_take(), equal_take("first", 180, 1)});
  Live live(library, exchanging_take().a);
  live.commands.push(SetRoleControl{RoleControl::Library});
  live.run_until(1.3);
  IntendedMove move;
  move.label = "turn";
  move.until_s = 2.1;
  live.commands.push(IntendMove{move});
  live.run_until(2.3);
  live.commands.push(PinPair{20});
  live.run_until(2.6);
  live.commands.push(PinPair{});
  live.commands.push(SetVetoes{{{}, {"first"}, {}}});
  live.run_until(3.9);
  const auto all = live.history.since(0);
  std::set<UserRole> roles;
  for (const auto& frame : all) roles.insert(frame->settings.user_role);
  ASSERT_EQ(roles.size(), 2U);
  auto again = std::move(*ReSolver::create(library, {}));
  for (const auto& [from_s, to_s] : {std::pair(0.0, 3.9), std::pair(1.5, 2.5), std::pair(1.9, 3.0)}) {
    auto found = live.history.solvable_again(from_s, to_s);
    FrameSnapshotPtr recorded = found.frames.next();
    ASSERT_TRUE(recorded);
    again->go_to(found.run_up, *recorded);
    for (; recorded; recorded = found.frames.next()) {
      const auto solved = again->solve(*recorded, recorded->settings);
      ASSERT_EQ(solved->result.result, recorded->result.result) << "frame " << recorded->index;
      ASSERT_EQ(solved->result.selected, recorded->result.selected) << "frame " << recorded->index;
    }
  }
}

}  // namespace
}  // namespace abrazo::role_switch_test
