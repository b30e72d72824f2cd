#include "core/choreography/footwork.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace abrazo::footwork_test {
namespace {

const Vec3 here(0, 0.04, 0), there(0.1, 0.04, 0.3);

Footwork one_step() {
  Footwork foot(here, 0.2);
  foot.add({.start = 1, .end = 2, .toe_base = there, .yaw = 0.6, .lift = 0.06, .heel = 0.4});
  return foot;
}

TEST(Footwork, StandsStillBetweenMoves) {
  const Footwork foot = one_step();
  for (const double beat : {-3.0, 0.0, 0.5, 1.0}) EXPECT_EQ(foot.at(beat).toe_base, here);
  for (const double beat : {2.0, 2.5, 100.0}) {
    EXPECT_EQ(foot.at(beat).toe_base, there);
    EXPECT_EQ(foot.at(beat).yaw, 0.6);
    EXPECT_EQ(foot.at(beat).heel_pitch, 0);
  }
}

TEST(Footwork, AStepLiftsTheFootOverTheFloorHalfWay) {
  const FootPosture middle = one_step().at(1.5);
  EXPECT_NEAR(middle.toe_base.y(), 0.04 + 0.06, 1e-12);
  EXPECT_NEAR(middle.toe_base.z(), 0.15, 1e-12);
  EXPECT_GT(middle.heel_pitch, 0.2);
}

TEST(Footwork, NeverGoesBelowTheFloor) {
  const Footwork foot = one_step();
  for (double beat = 0; beat < 3; beat += 0.01) EXPECT_GE(foot.at(beat).toe_base.y(), 0.04);
}

TEST(Footwork, APivotTurnsTheFootOnTheSpot) {
  Footwork foot(here, 0);
  foot.add({.start = 0, .end = 1, .toe_base = here, .yaw = -1, .lift = 0, .heel = 0.1});
  for (double beat = 0; beat < 1.2; beat += 0.05) EXPECT_EQ(foot.at(beat).toe_base, here);
  EXPECT_NEAR(foot.at(0.5).yaw, -0.5, 1e-12);
}

TEST(Footwork, ADetourLeadsRoundTheStandingFoot) {
  Footwork foot(here, 0);
  foot.add({.start = 0, .end = 1, .toe_base = there, .lift = 0.06, .detour = {0.05, 0, 0}});
  EXPECT_NEAR((foot.at(0.5).toe_base - Vec3(0.05 + 0.05, 0.04 + 0.06, 0.15)).norm(), 0, 1e-12);
  EXPECT_EQ(foot.at(1).toe_base, there);
}

TEST(Footwork, RefusesMovesThatOverlapOrTakeNoTime) {
  Footwork foot = one_step();
  EXPECT_THROW(foot.add({.start = 1.9, .end = 2.5, .toe_base = here}), std::invalid_argument);
  EXPECT_THROW(foot.add({.start = 3, .end = 3, .toe_base = here}), std::invalid_argument);
}

}  // namespace
}  // namespace abrazo::footwork_test
