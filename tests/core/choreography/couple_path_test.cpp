#include "core/choreography/couple_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace abrazo::couple_path_test {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

/// The figure between two open basics that stay where they are.
CouplePath path_of(SalsaFigure figure) {
  SalsaPhrase basic{.figure = SalsaFigure::OpenBasic, .distance = 0.7};
  SalsaPhrase middle{.figure = figure, .distance = 0.7, .walk = 1.2};
  if (figure == SalsaFigure::CrossBodyLead || figure == SalsaFigure::InsideTurn)
    middle.couple_turn = std::numbers::pi;
  return CouplePath({basic, middle, basic});
}

/// How far one has turned relative to the partner over the figure [turns].
struct Turned {
  double leader, follower, places;
};
Turned turned(SalsaFigure figure) {
  const CouplePath path = path_of(figure);
  const auto direction = [&](double beat) {
    const Vec3 d = path.follower(beat).place - path.leader(beat).place;
    return std::atan2(d.x(), d.z());
  };
  double places = 0;
  for (double beat = 4; beat < 19.95; beat += 0.1)
    places += std::remainder(direction(beat + 0.1) - direction(beat), full_turn);
  return {(path.leader(20).heading - path.leader(4).heading - places) / full_turn,
          (path.follower(20).heading - path.follower(4).heading - places) / full_turn, places / full_turn};
}

TEST(CouplePath, TheyFaceOneAnotherBetweenFigures) {
  for (const SalsaFigure figure : {SalsaFigure::FollowerRightTurn, SalsaFigure::CrossBodyLead,
                                   SalsaFigure::WalkInTandem, SalsaFigure::InAndOut}) {
    const CouplePath path = path_of(figure);
    for (const double beat : {4.0, 20.0}) {
      const Spot his = path.leader(beat), hers = path.follower(beat);
      const Vec3 between = (hers.place - his.place).normalized();
      EXPECT_GT(forward_of(his.heading).dot(between), 0.999);
      EXPECT_LT(forward_of(hers.heading).dot(between), -0.999);
      EXPECT_NEAR((hers.place - his.place).norm(), 0.7, 1e-9);
    }
  }
}

TEST(CouplePath, OnlyTurnsTurnOneRelativeToTheOther) {
  for (const SalsaFigure figure :
       {SalsaFigure::OpenBasic, SalsaFigure::ClosedBasic, SalsaFigure::CrossBodyLead,
        SalsaFigure::WalkToHisLeft, SalsaFigure::WalkToHisRight, SalsaFigure::WalkInTandem,
        SalsaFigure::InAndOut}) {
    EXPECT_NEAR(turned(figure).leader, 0, 1e-6);
    EXPECT_NEAR(turned(figure).follower, 0, 1e-6);
  }
  EXPECT_NEAR(turned(SalsaFigure::FollowerRightTurn).follower, -1, 1e-6);
  EXPECT_NEAR(turned(SalsaFigure::FollowerLeftTurn).follower, 1, 1e-6);
  EXPECT_NEAR(turned(SalsaFigure::InsideTurn).follower, 1, 1e-6);
  EXPECT_NEAR(turned(SalsaFigure::LeaderRightTurn).leader, -1, 1e-6);
  EXPECT_NEAR(turned(SalsaFigure::LeaderLeftTurn).leader, 1, 1e-6);
}

TEST(CouplePath, OnlyCrossBodyLeadsExchangePlacesAndToTheLeft) {
  EXPECT_NEAR(turned(SalsaFigure::CrossBodyLead).places, 0.5, 1e-6);
  EXPECT_NEAR(turned(SalsaFigure::InsideTurn).places, 0.5, 1e-6);
  for (const SalsaFigure figure : {SalsaFigure::FollowerRightTurn, SalsaFigure::LeaderLeftTurn,
                                   SalsaFigure::WalkToHisLeft, SalsaFigure::InAndOut})
    EXPECT_NEAR(turned(figure).places, 0, 1e-6);
}

TEST(CouplePath, InAWalkSheIsOnHisRightOrOnHisLeftOrInFront) {
  const auto seen_by_him = [](SalsaFigure figure) -> Vec3 {
    const CouplePath path = path_of(figure);
    const Spot his = path.leader(11.7), hers = path.follower(11.7);
    EXPECT_GT(forward_of(his.heading).dot(forward_of(hers.heading)), 0.85);
    const Vec3 d = hers.place - his.place;
    return {d.dot(left_of(his.heading)), 0, d.dot(forward_of(his.heading))};
  };
  EXPECT_LT(seen_by_him(SalsaFigure::WalkToHisLeft).x(), -0.5);
  EXPECT_GT(seen_by_him(SalsaFigure::WalkToHisRight).x(), 0.5);
  EXPECT_GT(seen_by_him(SalsaFigure::WalkInTandem).z(), 0.5);
  EXPECT_LT(seen_by_him(SalsaFigure::InAndOut).x(), -0.4);
}

}  // namespace
}  // namespace abrazo::couple_path_test
