#include "core/synthesis/edit/foot_locks.hpp"

#include <gtest/gtest.h>

#include "tests/support/bodies.hpp"

namespace abrazo::foot_locks_test {
namespace {

/// All four feet standing where `pair` has them.
FootLocks::Situations standing(const PairPose& pair) {
  FootLocks::Situations feet;
  for (std::size_t f = 0; f < feet.size(); ++f) {
    const int ankle = FootLocks::ankles[f];
    feet[f] = {true, pair.row(ankle - 2), pair.row(ankle + 1), 0.85};
  }
  return feet;
}

std::vector<FootLock> locked(const FootLocks& locks) {
  std::vector<FootLock> list;
  locks.list(2, list);
  return list;
}

TEST(FootLocks, AFootIsHeldFromTheSecondLandedFrameOn) {
  const PairPose pair = test::facing_pair(0.7);
  FootLocks locks;
  locks.update(standing(pair), nullptr, false);
  EXPECT_TRUE(locked(locks).empty());
  locks.update(standing(pair), &pair, false);
  EXPECT_EQ(locked(locks).size(), 4U);
}

TEST(FootLocks, ItIsHeldWhereThePreviousResultHadIt) {
  PairPose pair = test::facing_pair(0.7);
  FootLocks locks;
  locks.update(standing(pair), nullptr, false);
  PairPose previous = pair;
  previous.row(FootLocks::ankles[2]) += Eigen::RowVector3d(0.01, 0, 0);
  locks.update(standing(pair), &previous, false);
  std::vector<ConstraintRow> rows;
  locks.add_rows(2, rows);
  EXPECT_EQ(rows.size(), 24U);
  for (const ConstraintRow& row : rows) EXPECT_NEAR(row.value(previous), row.target, 1e-12);
  // Later results do not move the place: it was fixed when the lock began.
  PairPose drifted = previous;
  drifted.array() += 0.02;
  locks.update(standing(pair), &drifted, false);
  EXPECT_NEAR(locks.drift(2, previous), 0, 1e-12);
}

TEST(FootLocks, ALiftedFootIsLetGo) {
  const PairPose pair = test::facing_pair(0.7);
  FootLocks locks;
  auto feet = standing(pair);
  locks.update(feet, nullptr, false);
  locks.update(feet, &pair, false);
  feet[3].landed = false;
  locks.update(feet, &pair, false);
  const std::vector<FootLock> expected = {{true, true}, {true, false}, {false, true}};
  EXPECT_EQ(locked(locks), expected);
  EXPECT_TRUE(locks.passive_released()[1]);
  locks.update(feet, &pair, false);
  EXPECT_FALSE(locks.passive_released()[1]) << "released is said once";
}

TEST(FootLocks, ThePartnersFootIsLetGoBeyondTwentyCentimetres) {
  const PairPose pair = test::facing_pair(0.7);
  auto feet = standing(pair);
  FootLocks locks;
  locks.update(feet, nullptr, false);
  locks.update(feet, &pair, false);
  feet[2].toe_base.x() += 0.19;
  locks.update(feet, &pair, false);
  EXPECT_EQ(locked(locks).size(), 4U);
  feet[2].toe_base.x() += 0.02;
  locks.update(feet, &pair, false);
  EXPECT_EQ(locked(locks).size(), 3U);
}

TEST(FootLocks, AtAChangeOfSourceOnlyFeetWithinTenCentimetresStayHeld) {
  const PairPose pair = test::facing_pair(0.7);
  auto feet = standing(pair);
  FootLocks locks;
  locks.update(feet, nullptr, false);
  locks.update(feet, &pair, false);
  feet[2].toe_base.z() += 0.12;
  feet[3].toe_base.z() += 0.08;
  locks.update(feet, &pair, true);
  const std::vector<FootLock> expected = {{true, true}, {true, false}, {false, false}};
  EXPECT_EQ(locked(locks), expected);
}

TEST(FootLocks, AStretchedLegLetsGo) {
  const PairPose pair = test::facing_pair(0.7);
  auto feet = standing(pair);
  FootLocks locks;
  locks.update(feet, nullptr, false);
  locks.update(feet, &pair, false);
  feet[2].leg_length = 0.5;  // hip to ankle is more
  locks.update(feet, &pair, false);
  EXPECT_EQ(locked(locks).size(), 3U);
}

TEST(FootLocks, ThoseOfTheFirstBodiesAreListed) {
  const PairPose pair = test::facing_pair(0.7);
  FootLocks locks;
  locks.update(standing(pair), nullptr, false);
  locks.update(standing(pair), &pair, false);
  for (const int bodies : {0, 1, 2}) {
    std::vector<FootLock> list;
    locks.list(bodies, list);
    EXPECT_EQ(list.size(), static_cast<std::size_t>(2 * bodies));
    EXPECT_EQ(locks.held(bodies), 2 * bodies);
  }
}

TEST(FootLocks, ReleasedBodiesAreForgotten) {
  const PairPose pair = test::facing_pair(0.7);
  FootLocks locks;
  locks.update(standing(pair), nullptr, false);
  locks.update(standing(pair), &pair, false);
  locks.release(1);
  const std::vector<FootLock> expected = {{true, true}, {true, false}};
  EXPECT_EQ(locked(locks), expected);
}

}  // namespace
}  // namespace abrazo::foot_locks_test
