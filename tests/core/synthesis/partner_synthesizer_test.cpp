#include "core/synthesis/step/partner_synthesizer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/library/build/motion_library_builder.hpp"
#include "core/selection/pair_selector.hpp"
#include "core/synthesis/frames/trace.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::partner_synthesizer_test {
namespace {

constexpr Duration step_time(1.0 / 15);

std::unique_ptr<PartnerSynthesizer> synthesizer_with(const Settings& settings) {
  return std::move(*PartnerSynthesizer::create(test::small_library(), settings));
}

Settings without_memory() {
  Settings settings = *preset("paper");
  settings.velocity_weight = 0;
  settings.foot_locks = false;
  return settings;
}

TEST(PartnerSynthesizer, TheUsersOwnRecordedPairComesBackUnchanged) {
  const auto library = test::small_library();
  for (const auto weights : {EdgeWeights::Inverse, EdgeWeights::InverseMean, EdgeWeights::Uniform}) {
    Settings settings = without_memory();
    settings.edge_weights = weights;
    auto synthesizer = std::move(*PartnerSynthesizer::create(library, settings));
    const PairedTake take = test::swinging_take("first", 180, 1);
    synthesizer->set_user_body(library->usual_active_body().body);
    for (int frame = 0; frame < 180; frame += 4) {
      synthesizer->pin_pair(library->find_pair("first", frame, false));
      const auto at = static_cast<std::size_t>(frame);
      const FrameResult& result = synthesizer->step(take.a.poses[at], step_time);
      ASSERT_EQ(result.status, StepStatus::Ok) << result.message;
      EXPECT_LT((result.active() - take.a.poses[at]).cwiseAbs().maxCoeff(), 1e-6) << "frame " << frame;
      EXPECT_LT((result.passive() - take.b.poses[at]).cwiseAbs().maxCoeff(), 1e-6) << "frame " << frame;
    }
  }
}

TEST(PartnerSynthesizer, EveryFrameKeepsBonesAndLocks) {
  for (const auto name : preset_names) {
    auto synthesizer = synthesizer_with(*preset(name));
    const Clip user = test::swinging_take("user", 300, 17).a;
    int locked = 0;
    for (std::size_t frame = 0; frame < user.poses.size(); frame += 2) {
      const FrameResult& result = synthesizer->step(user.poses[frame], Duration(1.0 / 30));
      ASSERT_NE(result.status, StepStatus::Failed) << result.message;
      const Body active = body_of(Pose(result.active()));
      const Body passive = body_of(Pose(result.passive()));
      EXPECT_LT(largest_length_difference(active, synthesizer->library().usual_active_body().body), 1e-3);
      EXPECT_LT(largest_length_difference(passive, synthesizer->library().usual_passive_body().body), 1e-3);
      EXPECT_LT(result.residual.bone_length_max, 1e-3);
      EXPECT_LT(result.residual.foot_lock_max_m, 1e-3);
      locked += static_cast<int>(result.foot_locks.size());
    }
    EXPECT_GT(locked, 0) << "the case must lock feet to test anything";
  }
}

TEST(PartnerSynthesizer, CollisionsThatContradictTheBonesAreLetGoAndTheFloorIsKept) {
  // Two people who stand in each other's arms, and a user who is somewhere else in every frame.
  std::vector<PairedTake> takes;
  takes.push_back(test::swinging_take("close", 120, 1, 0.35));
  Settings settings = *preset("responsive");
  settings.playback = SourcePlayback::Frames;
  settings.velocity_weight = 0.05;
  auto synthesizer = std::move(*PartnerSynthesizer::create(
      std::make_shared<const MotionLibrary>(std::move(*build_library("close", std::move(takes), {}, {}))),
      settings));
  synthesizer->set_user_body(body_of(test::standing_pose()));
  std::mt19937 random(7);
  int let_go = 0;
  std::normal_distribution<double> turn(0, 1), away(0, 0.4);
  for (const Pose& pose : test::swinging_take("user", 1200, 17).a.poses) {
    const double yaw = turn(random), x = away(random), z = away(random);
    const FrameResult& result = synthesizer->step(test::moved(pose, yaw, Vec3(x, 0, z)), Duration(1.0 / 60));
    EXPECT_NE(result.message, "only bone lengths were kept");
    let_go += result.message == "foot locks and collisions were let go";
  }
  EXPECT_GT(let_go, 0) << "the case must contradict itself to test anything";
}

TEST(PartnerSynthesizer, CapsulesAreLookedAtOnceMoreWhereTheLastStepLeftThem) {
  // Two people in each other's arms, and a user whose joints jump about: what is linear where the last step
  // begins says too little about its end now and then.
  std::vector<PairedTake> takes;
  takes.push_back(test::swinging_take("close", 120, 1, 0.3));
  Settings settings = without_memory();
  auto synthesizer = std::move(*PartnerSynthesizer::create(
      std::make_shared<const MotionLibrary>(std::move(*build_library("close", std::move(takes), {}, {}))),
      settings));
  std::mt19937 random(5);
  int touching = 0;
  double deepest_m = 0;
  for (const unsigned seed : {17U, 18U, 19U})
    for (const Pose& pose : test::swinging_take("user", 300, seed).a.poses) {
      const FrameResult& result = synthesizer->step(test::shaken(pose, 0.1, random), step_time);
      if (result.status != StepStatus::Ok) continue;
      touching += !result.collisions.empty();
      deepest_m = std::max(deepest_m, result.residual.excess_penetration_max_m);
    }
  EXPECT_GT(touching, 100) << "the case must bring the bodies together to test anything";
  EXPECT_LT(deepest_m, 1e-3);
}

TEST(PartnerSynthesizer, EqualInputGivesTheSameBits) {
  const Clip user = test::swinging_take("user", 120, 23).a;
  const auto trace_of = [&] {
    auto synthesizer = synthesizer_with(*preset("responsive"));
    std::string trace;
    for (const Pose& pose : user.poses) {
      FrameResult result = synthesizer->step(pose, Duration(1.0 / 60));
      result.timing = {};
      trace += trace_frame_line(result, synthesizer->library(), 0, 0);
    }
    return trace;
  };
  EXPECT_EQ(trace_of(), trace_of());
}

TEST(PartnerSynthesizer, ChangingTheSettingsWhileRunningTakesEffect) {
  const Clip user = test::swinging_take("user", 60, 5).a;
  auto synthesizer = synthesizer_with(*preset("paper"));
  for (std::size_t frame = 0; frame < 40; frame += 4) synthesizer->step(user.poses[frame], step_time);
  Settings settings = synthesizer->settings();
  settings.neighbours = 3;
  synthesizer->set_settings(settings);
  EXPECT_EQ(synthesizer->step(user.poses[40], step_time).candidates.size(), 3U);
}

TEST(PartnerSynthesizer, TheFirstFrameHasNoTemporalTerms) {
  const Clip user = test::swinging_take("user", 60, 5).a;
  auto synthesizer = synthesizer_with(*preset("paper"));
  const FrameResult first = synthesizer->step(user.poses[0], Duration(0));
  for (const Candidate& candidate : first.candidates) EXPECT_EQ(candidate.cost.total, candidate.cost.pose);
  EXPECT_EQ(first.energy.velocity, 0);
  const FrameResult second = synthesizer->step(user.poses[4], step_time);
  EXPECT_GT(second.candidates.front().cost.temporal_passive, 0);
}

TEST(PartnerSynthesizer, StartsAnewAfterTrackingLoss) {
  const Clip user = test::swinging_take("user", 60, 5).a;
  auto synthesizer = synthesizer_with(*preset("paper"));
  for (std::size_t frame = 0; frame < 20; frame += 4) synthesizer->step(user.poses[frame], step_time);
  auto fresh = synthesizer_with(*preset("paper"));
  const PairPose after_loss = synthesizer->step(user.poses[40], Duration(0.31)).result;
  EXPECT_EQ(after_loss, fresh->step(user.poses[40], Duration(0)).result);
}

TEST(PartnerSynthesizer, AfterALossOfTrackingNothingIsLeftOfWhatWasFollowed) {
  const Clip user = test::swinging_take("user", 60, 5).a;
  Settings successors = *preset("paper");
  successors.continuations = 3;
  for (const Settings& settings : {*preset("paper"), successors}) {
    auto lost = synthesizer_with(settings), fresh = synthesizer_with(settings);
    lost->pin_pair(lost->library().find_pair("second", 100, false));
    lost->step(user.poses[0], Duration(0));
    lost->pin_pair(std::nullopt);
    const FrameResult& again = lost->step(user.poses[40], Duration(0.31));
    const FrameResult& first = fresh->step(user.poses[40], Duration(0));
    EXPECT_FALSE(again.source_changed) << "there is none that could change";
    EXPECT_EQ(again.candidates.size(), first.candidates.size());
    EXPECT_EQ(again.result, first.result);
  }
}

TEST(PartnerSynthesizer, TheTimesOfAStepAreOfItsParts) {
  const Clip user = test::swinging_take("user", 60, 5).a;
  for (const auto name : preset_names) {
    auto synthesizer = synthesizer_with(*preset(name));
    for (std::size_t frame = 0; frame < 8; ++frame) {
      const StepTiming& timing = synthesizer->step(user.poses[frame], step_time).timing;
      for (const double part_us : {timing.retarget_us, timing.select_us, timing.mesh_us, timing.solve_us})
        EXPECT_GT(part_us, 0);
      EXPECT_GE(timing.total_us, timing.retarget_us + timing.select_us + timing.mesh_us + timing.solve_us);
    }
  }
}

TEST(PartnerSynthesizer, AUserWithoutAPositionFailsTheFrameAndHoldsThePartner) {
  const Clip user = test::swinging_take("user", 60, 5).a;
  auto synthesizer = synthesizer_with(*preset("paper"));
  const PairPose good = synthesizer->step(user.poses[0], Duration(0)).result;
  Pose broken = user.poses[4];
  broken(joints::LeftHand, 1) = std::numeric_limits<double>::quiet_NaN();
  const FrameResult& failed = synthesizer->step(broken, step_time);
  EXPECT_EQ(failed.status, StepStatus::Failed);
  EXPECT_NE(failed.message.find("lhand"), std::string::npos);
  EXPECT_EQ(failed.result, good);
  EXPECT_EQ(synthesizer->step(user.poses[8], step_time).status, StepStatus::Ok);
}

TEST(PartnerSynthesizer, NeverThrowsAndNeverGivesAPoseThatIsNotFinite) {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> anywhere(-1, 1);
  std::uniform_real_distribution<double> exponent(-310, 308);
  std::uniform_int_distribution<int> kind(0, 9);
  for (const auto name : preset_names) {
    auto synthesizer = synthesizer_with(*preset(name));
    for (int frame = 0; frame < 300; ++frame) {
      Pose user = test::shaken(test::standing_pose(), 0.05, random);
      switch (kind(random)) {
        case 0:
          user *= std::pow(10.0, exponent(random));
          break;
        case 1:
          user.setZero();
          break;
        case 2:
          user(3, 1) = std::numeric_limits<double>::infinity();
          break;
        case 3:
          user.row(7) += 3 * Eigen::RowVector3d(anywhere(random), anywhere(random), anywhere(random));
          break;
        case 4:
          user.rowwise() += 1e3 * Eigen::RowVector3d(anywhere(random), 0, anywhere(random));
          break;
        default:
          break;
      }
      ASSERT_NO_THROW({
        const FrameResult& result = synthesizer->step(user, Duration(frame % 50 == 49 ? 1.0 : 1.0 / 30));
        ASSERT_TRUE(result.result.allFinite()) << "frame " << frame;
      });
    }
  }
}

TEST(PartnerSynthesizer, AnUnknownTakeToLeaveOutIsAnErrorThatListsTheTakes) {
  const auto refused = PartnerSynthesizer::create(test::small_library(), *preset("paper"), {"third"});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().text().find("first, second"), std::string::npos);
}

TEST(PartnerSynthesizer, LeavingOutEveryTakeIsAnError) {
  EXPECT_FALSE(PartnerSynthesizer::create(test::small_library(), *preset("paper"), {"first", "second"}));
}

TEST(PartnerSynthesizer, AUserOfAnotherSizeGetsTheSamePartner) {
  const PairedTake take = test::swinging_take("user", 90, 12);
  const auto last_hold = [&](double scale) {
    auto synthesizer = synthesizer_with(*preset("paper"));
    Clip user = take.a;
    for (Pose& pose : user.poses) pose *= scale;
    synthesizer->set_user_body(body_of(user.poses));
    PairPose last;
    for (std::size_t frame = 0; frame < user.poses.size(); frame += 4)
      last = synthesizer->step(user.poses[frame], step_time).result;
    return last;
  };
  const PairPose normal = last_hold(1.0);
  for (const double scale : {0.85, 1.15})
    EXPECT_LT((last_hold(scale) - normal).cwiseAbs().maxCoeff(), 0.02) << scale;
}

TEST(PartnerSynthesizer, APassiveUserGetsTheRecordedLeader) {
  const auto library = test::small_library();
  Settings settings = without_memory();
  settings.user_role = UserRole::Passive;
  auto synthesizer = std::move(*PartnerSynthesizer::create(library, settings));
  const PairedTake take = test::swinging_take("first", 180, 1);
  synthesizer->set_user_body(library->usual_passive_body().body);
  for (int frame = 0; frame < 180; frame += 30) {
    synthesizer->pin_pair(library->find_pair("first", frame, false));
    const auto at = static_cast<std::size_t>(frame);
    const FrameResult& result = synthesizer->step(take.b.poses[at], step_time);
    ASSERT_EQ(result.status, StepStatus::Ok) << result.message;
    EXPECT_LT((result.passive() - take.b.poses[at]).cwiseAbs().maxCoeff(), 1e-6)
        << "the user is the passive body";
    EXPECT_LT((result.active() - take.a.poses[at]).cwiseAbs().maxCoeff(), 1e-6) << "the partner leads";
    EXPECT_EQ(result.candidates[static_cast<std::size_t>(result.selected)].pair,
              library->find_pair("first", frame, false));
    const RootFrame user_root = root_frame(take.b.poses[at]);
    const PairPose ghost = library->pair_in_world(library->find_pair("first", frame, false), user_root, true);
    EXPECT_LT((ghost - result.selected_pair).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(PartnerSynthesizer, TheUserCanChangeRolesWhileRunning) {
  const PairedTake take = test::swinging_take("user", 60, 5);
  auto synthesizer = synthesizer_with(*preset("paper"));
  synthesizer->step(take.a.poses[0], Duration(0));
  Settings settings = synthesizer->settings();
  settings.user_role = UserRole::Passive;
  synthesizer->set_settings(settings);
  const FrameResult& passive = synthesizer->step(take.a.poses[4], step_time);
  // The library's performers differ by 7 % in size, and so do the characters from now on: a foot that was
  // held may have to be let go, which the step says.
  EXPECT_NE(passive.status, StepStatus::Failed) << passive.message;
  EXPECT_LT((passive.passive() - take.a.poses[4]).rowwise().norm().maxCoeff(), 0.15);

  // Somebody else, of the follower's size, has nothing to go on from and nothing to let go of.
  synthesizer->reset();
  synthesizer->forget_user_body();
  const FrameResult& first = synthesizer->step(take.b.poses[4], step_time);
  EXPECT_EQ(first.status, StepStatus::Ok) << first.message;
  EXPECT_LT((first.passive() - take.b.poses[4]).rowwise().norm().maxCoeff(), 0.15);
}

TEST(PartnerSynthesizer, ADoubledLibraryGivesTheRecordedPairBackToo) {
  std::vector<PairedTake> takes;
  takes.push_back(test::swinging_take("first", 90, 1));
  takes[0].roles.clear();  // unknown: both assignments are kept
  const auto library =
      std::make_shared<const MotionLibrary>(std::move(*build_library("doubled", std::move(takes), {}, {})));
  ASSERT_EQ(library->pair_count(), 180);
  auto synthesizer = std::move(*PartnerSynthesizer::create(library, without_memory()));
  const PairedTake take = test::swinging_take("first", 90, 1);
  synthesizer->set_user_body(body_of(take.a.poses));
  for (std::size_t frame = 0; frame < 90; frame += 15) {
    synthesizer->pin_pair(library->find_pair("first", static_cast<int>(frame), false));
    const FrameResult& result = synthesizer->step(take.a.poses[frame], step_time);
    EXPECT_LT((result.passive() - take.b.poses[frame]).cwiseAbs().maxCoeff(), 1e-6) << "frame " << frame;
  }
}

TEST(PartnerSynthesizer, TwoSecondsWithoutTrackingStartAnew) {
  const Clip user = test::swinging_take("user", 120, 5).a;
  auto synthesizer = synthesizer_with(*preset("paper"));
  for (std::size_t frame = 0; frame < 20; frame += 4) synthesizer->step(user.poses[frame], step_time);
  const Pose lost = Pose::Constant(std::numeric_limits<double>::quiet_NaN());
  for (int frame = 0; frame < 30; ++frame)
    EXPECT_EQ(synthesizer->step(lost, step_time).status, StepStatus::Failed);
  auto fresh = synthesizer_with(*preset("paper"));
  EXPECT_EQ(synthesizer->step(user.poses[100], step_time).result,
            fresh->step(user.poses[100], Duration(0)).result);
}

TEST(PartnerSynthesizer, OneLostFrameCountsAsTimeForThePrediction) {
  const Clip user = test::swinging_take("user", 60, 5).a;
  const auto last_with = [&](bool lose_one) {
    auto synthesizer = synthesizer_with(*preset("paper"));
    for (std::size_t frame = 0; frame <= 20; frame += 4) synthesizer->step(user.poses[frame], step_time);
    if (lose_one) {
      synthesizer->step(Pose::Constant(std::numeric_limits<double>::quiet_NaN()), step_time);
      return FrameResult(synthesizer->step(user.poses[28], step_time));
    }
    return FrameResult(synthesizer->step(user.poses[28], 2 * step_time));
  };
  EXPECT_EQ(last_with(true).result, last_with(false).result);
}

TEST(PartnerSynthesizer, AUserWhoJumpsAwayIsFollowedWithinHalfASecond) {
  const Clip user = test::swinging_take("user", 240, 5).a;
  for (const auto name : preset_names)
    for (const double jump_m : {2.0, 100.0, 5000.0}) {
      auto synthesizer = synthesizer_with(*preset(name));
      for (std::size_t frame = 0; frame < 60; ++frame)
        synthesizer->step(user.poses[frame], Duration(1.0 / 60));
      int failed = 0;
      for (std::size_t frame = 60; frame < 120; ++frame) {
        const FrameResult& result =
            synthesizer->step(test::moved(user.poses[frame], 0, Vec3(jump_m, 0, 0)), Duration(1.0 / 60));
        failed += result.status == StepStatus::Failed;
      }
      EXPECT_LE(failed, 25) << name << ' ' << jump_m;
      const FrameResult& last =
          synthesizer->step(test::moved(user.poses[120], 0, Vec3(jump_m, 0, 0)), Duration(1.0 / 60));
      EXPECT_NE(last.status, StepStatus::Failed) << name << ' ' << jump_m;
      EXPECT_NEAR(last.result(0, 0), user.poses[120](0, 0) + jump_m, 0.2) << name;
    }
}

TEST(PartnerSynthesizer, AFailedFrameKeepsNothingOfThePreviousOne) {
  const Clip user = test::swinging_take("user", 60, 5).a;
  auto synthesizer = synthesizer_with(*preset("paper"));
  synthesizer->step(user.poses[0], Duration(0));
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e308}) {
    const FrameResult& failed = synthesizer->step(Pose::Constant(bad), step_time);
    EXPECT_EQ(failed.status, StepStatus::Failed);
    EXPECT_TRUE(failed.selected == -1 || failed.selected < static_cast<int>(failed.candidates.size()));
    EXPECT_EQ(failed.edge_weights.size(), failed.edge_residuals_m.size());
    EXPECT_TRUE(failed.edges.empty() || failed.edges.size() == failed.edge_weights.size() ||
                failed.edge_weights.empty());
  }
}

TEST(PartnerSynthesizer, SomethingThatIsNoPersonIsHeldAndSaidAndAPersonIsFollowedAgainAtOnce) {
  const Clip user = test::swinging_take("user", 60, 5).a;
  Pose torn = user.poses[4];
  torn.row(joints::LeftHand) += Eigen::RowVector3d(2e5, 0, 0);
  const std::vector<Pose> nobody = {Pose::Constant(1), 100 * user.poses[4], torn,
                                    test::moved(user.poses[4], 0, Vec3(0, 100, 0))};
  for (const auto name : preset_names) {
    auto synthesizer = synthesizer_with(*preset(name));
    PairPose good = synthesizer->step(user.poses[0], Duration(0)).result;
    for (std::size_t i = 0; i < nobody.size(); ++i) {
      const FrameResult& held = synthesizer->step(nobody[i], Duration(1.0 / 60));
      EXPECT_EQ(held.status_text().find("failed: held: not a person: "), 0U) << held.status_text();
      EXPECT_EQ(held.result, good);
      const FrameResult& again = synthesizer->step(user.poses[i + 1], Duration(1.0 / 60));
      ASSERT_NE(again.status, StepStatus::Failed) << again.message;
      good = again.result;
    }
  }
}

TEST(PartnerSynthesizer, SomethingThatIsNoPersonIsNotMeasured) {
  auto synthesizer = synthesizer_with(*preset("paper"));
  const FrameResult& refused = synthesizer->step(100 * test::standing_pose(), Duration(0));
  EXPECT_EQ(refused.status, StepStatus::Failed);
  EXPECT_NE(refused.message.find("unit"), std::string::npos);
  EXPECT_EQ(synthesizer->step(test::standing_pose(), step_time).status, StepStatus::Ok)
      << "measured from the first good pose";
}

TEST(PartnerSynthesizer, LocksSwitchedOffAndOnAgainDoNotPullFeetBack) {
  const Clip user = test::swinging_take("user", 120, 5).a;
  auto synthesizer = synthesizer_with(*preset("paper"));
  Settings settings = synthesizer->settings();
  for (std::size_t frame = 0; frame < 40; frame += 4) synthesizer->step(user.poses[frame], step_time);
  settings.foot_locks = false;
  synthesizer->set_settings(settings);
  for (std::size_t frame = 40; frame < 80; frame += 4)
    EXPECT_TRUE(synthesizer->step(user.poses[frame], step_time).foot_locks.empty());
  settings.foot_locks = true;
  synthesizer->set_settings(settings);
  EXPECT_TRUE(synthesizer->step(user.poses[80], step_time).foot_locks.empty())
      << "a foot is held from its second landed frame on";
}

TEST(PartnerSynthesizer, WithEveryPairVetoedTheFrameFailsSaysSoAndHoldsThePartner) {
  const Clip user = test::swinging_take("user", 60, 5).a;
  auto synthesizer = synthesizer_with(*preset("paper"));
  const PairPose good = synthesizer->step(user.poses[0], Duration(0)).result;
  synthesizer->set_vetoes({{}, {"first", "second"}, {}});
  const FrameResult& failed = synthesizer->step(user.poses[4], step_time);
  EXPECT_EQ(failed.status_text(), "failed: every recorded pair is vetoed; lift a veto to go on");
  EXPECT_EQ(failed.result, good);
  synthesizer->set_vetoes({});
  EXPECT_EQ(synthesizer->step(user.poses[8], step_time).status, StepStatus::Ok);
}

TEST(PartnerSynthesizer, VetoesOutliveAChangeOfTheUsersRole) {
  auto synthesizer = synthesizer_with(*preset("paper"));
  synthesizer->set_vetoes({{}, {"first"}, {}});
  Settings settings = synthesizer->settings();
  settings.user_role = UserRole::Passive;
  synthesizer->set_settings(settings);
  const FrameResult& result = synthesizer->step(test::standing_pose(), Duration(0));
  ASSERT_FALSE(result.candidates.empty());
  for (const Candidate& candidate : result.candidates)
    EXPECT_EQ(synthesizer->library().take_of(candidate.pair).name, "second");
}

TEST(PartnerSynthesizer, APinIsStrongerThanAVeto) {
  const auto library = test::small_library();
  auto synthesizer = synthesizer_with(*preset("paper"));
  const int pair = library->find_pair("first", 10, false);
  synthesizer->set_vetoes({{pair}, {"first", "second"}, {}});
  synthesizer->pin_pair(pair);
  const FrameResult& result = synthesizer->step(test::standing_pose(), Duration(0));
  ASSERT_EQ(result.candidates.size(), 1U);
  EXPECT_EQ(result.selected, 0);
  EXPECT_EQ(result.candidates[0].pair, pair);
}

TEST(PartnerSynthesizer, APairThatIsLeftOutCannotBePinned) {
  const auto library = test::small_library();
  auto synthesizer = std::move(*PartnerSynthesizer::create(library, *preset("paper"), {"first"}));
  synthesizer->pin_pair(library->find_pair("first", 10, false));
  const FrameResult& result = synthesizer->step(test::standing_pose(), Duration(0));
  EXPECT_EQ(library->take_of(result.candidates[static_cast<std::size_t>(result.selected)].pair).name,
            "second");
}

}  // namespace
}  // namespace abrazo::partner_synthesizer_test
