#include "core/choreography/fighter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/choreography/fight_score.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo::fight_score_test {
namespace {

Fighter standing(double height = 1.80) {
  RandomSource random(1);
  return Fighter(leader_body(height), {}, {}, 10, random);
}

TEST(Pulse, RisesStaysAndFallsWithoutAnEdge) {
  const Pulse pulse{1, 2, 3, 5};
  EXPECT_EQ(pulse.at(0.5), 0);
  EXPECT_NEAR(pulse.at(1.5), 0.5, 1e-12);
  EXPECT_EQ(pulse.at(2.5), 1);
  EXPECT_NEAR(pulse.at(4), 0.5, 1e-12);
  EXPECT_EQ(pulse.at(6), 0);
  for (const double corner : {1.0, 2.0, 3.0, 5.0})
    EXPECT_LT(std::abs(pulse.at(corner + 1e-3) - 2 * pulse.at(corner) + pulse.at(corner - 1e-3)) / 1e-6, 0.1);
}

TEST(Fighter, StandsWithTheLeftFootAndShoulderInFront) {
  const Pose pose = standing().pose(1);
  EXPECT_GT(pose(joints::left_toe_base, 2) - pose(joints::right_toe_base, 2), 0.35);
  EXPECT_GT(pose(joints::left_shoulder, 2) - pose(joints::right_shoulder, 2), 0.1);
  EXPECT_GT(pose(joints::left_hand, 2), pose(joints::right_hand, 2));
}

TEST(Fighter, ShufflesWithTheFootThatIsNearerToTheGoalFirst) {
  for (const double ahead : {0.3, -0.3}) {
    Fighter fighter = standing();
    fighter.shuffle(1, 0.5, {Vec3(0, 0, ahead), 0});
    fighter.settle(10);
    const Pose before = fighter.pose(1), half = fighter.pose(1.24), after = fighter.pose(1.5);
    const int first = ahead > 0 ? joints::left_toe_base : joints::right_toe_base,
              second = ahead > 0 ? joints::right_toe_base : joints::left_toe_base;
    EXPECT_GT(std::abs(half(first, 2) - before(first, 2)), 0.25);
    EXPECT_LT(std::abs(half(second, 2) - before(second, 2)), 0.01);
    for (const int toe_base : {first, second})
      EXPECT_NEAR(after(toe_base, 2) - before(toe_base, 2), ahead, 1e-9);
    EXPECT_NEAR(fighter.final_spot().place.z(), ahead, 1e-12);
  }
}

TEST(Fighter, GoesFarInSeveralShuffles) {
  Fighter fighter = standing();
  const double arrives = fighter.shuffle(1, 0.5, {Vec3(0, 0, 1.2), 0});
  fighter.settle(10);
  EXPECT_GT(arrives, 1.6);
  EXPECT_NEAR(fighter.spot(arrives).place.z(), 1.2, 1e-12);
  for (double time = 1; time < arrives; time += 0.01) {
    const Pose pose = fighter.pose(time);
    EXPECT_LT(std::abs(pose(joints::left_toe_base, 2) - pose(joints::right_toe_base, 2)), 1.0);
  }
}

TEST(Fighter, PivotsOnTheBallOfAStandingFoot) {
  Fighter fighter = standing();
  fighter.pivot(Side::Left, 1, 1.3, 1.0);
  fighter.settle(10);
  const Pose before = fighter.pose(1), after = fighter.pose(1.4);
  EXPECT_LT((before.row(joints::left_toe_base) - after.row(joints::left_toe_base)).norm(), 1e-9);
  const auto yaw = [](const Pose& pose) {
    const Vec3 foot = (pose.row(joints::left_toe_tip) - pose.row(joints::left_toe_base)).transpose();
    return std::atan2(foot.x(), foot.z());
  };
  EXPECT_NEAR(yaw(after) - yaw(before), 1.0, 1e-6);
}

TEST(Fighter, RefusesToMoveAFootThatIsOnItsWay) {
  Fighter fighter = standing();
  fighter.shuffle(1, 0.5, {Vec3(0, 0, 0.3), 0});
  EXPECT_THROW(fighter.shuffle(1.2, 0.5, {}), std::invalid_argument);
  LegMove kick;
  kick.chamber = {1.2, 1.4, 1.5, 1.7};
  EXPECT_THROW(fighter.add(Side::Right, kick), std::invalid_argument);
}

/// Blows of some fights.
std::vector<Blow> blows(double timing_error) {
  std::vector<Blow> all;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    RandomSource random(seed);
    const Performance performance{.timing_error_s = timing_error};
    Fighter a(leader_body(1.80), performance, {Vec3(0, 0, -0.65), 0}, 20, random);
    Fighter b(follower_body(1.66), performance, {Vec3(0, 0, 0.65), std::numbers::pi}, 20, random);
    const FightScore score(a, b, 20, 1, true, random);
    all.insert(all.end(), score.blows().begin(), score.blows().end());
  }
  return all;
}

TEST(FightScore, TheDefenderReactsAfterTheAttackHasBegunAndIsThereInTime) {
  for (const Blow& blow : blows(0)) {
    EXPECT_GE(blow.reacts - blow.start, 0.06);
    EXPECT_LE(blow.reacts - blow.start, 0.15);
    EXPECT_LE(blow.met, blow.impact + 0.02) << name_of(blow.attack.technique);
    EXPECT_LT(blow.start, blow.leaves);
    EXPECT_LT(blow.leaves, blow.impact);
    EXPECT_LE(blow.from, blow.start);
    EXPECT_LT(blow.released, blow.until + 1e-9);
  }
}

TEST(FightScore, ATimingErrorMakesHimEarlyAndLate) {
  int early = 0, late = 0;
  for (const Blow& blow : blows(0.08)) {
    early += blow.met < blow.impact - 0.04 ? 1 : 0;
    late += blow.met > blow.impact + 0.04 ? 1 : 0;
  }
  EXPECT_GT(early, 5);
  EXPECT_GT(late, 5);
}

TEST(FightScore, BlowsComeAloneAndInCombinations) {
  int alone = 0, combined = 0;
  const std::vector<Blow> all = blows(0);
  for (std::size_t i = 1; i < all.size(); ++i) ++(all[i].from == all[i - 1].until ? combined : alone);
  EXPECT_GT(alone, 20);
  EXPECT_GT(combined, 20);
}

}  // namespace
}  // namespace abrazo::fight_score_test
