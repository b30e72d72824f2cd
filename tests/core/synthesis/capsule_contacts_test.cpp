#include <algorithm>

#include "core/synthesis/edit/capsule_contacts.hpp"

#include <gtest/gtest.h>

#include "core/mesh/capsules.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::capsule_contacts_test {
namespace {

constexpr int upper_back_bone = joints::UpperBack - 1;

struct Measured {
  std::vector<CapsuleContact> contacts;
  double deepest = 0, excess = 0;
};

Measured measured(CapsuleContacts& capsules, const PairPose& pose) {
  Measured m;
  capsules.measure(pose, m.contacts, m.deepest, m.excess);
  return m;
}

TEST(CapsuleContacts, DepthOfOverlappingTrunksIsKnownByHand) {
  CapsuleRadii radii{};
  radii[upper_back_bone] = 0.15;
  CapsuleContacts capsules;
  capsules.prepare(test::facing_pair(2.0), radii, radii);
  // Back to back segments 0.2 m apart (their axes lean by 2 cm towards -Z of each body).
  PairPose close = test::facing_pair(0.2);
  const Measured m = measured(capsules, close);
  ASSERT_EQ(m.contacts.size(), 1U);
  const Vec3 a = close.row(joints::LowerBack);
  const Vec3 b = close.row(joints::UpperBack);
  const Vec3 c = close.row(joints::LowerBack + joint_count);
  const Vec3 d = close.row(joints::UpperBack + joint_count);
  EXPECT_NEAR(m.deepest, 0.30 - closest_points(a, b, c, d).distance, 1e-12);
  EXPECT_NEAR(m.excess, m.deepest, 1e-12) << "two metres apart the recording allows nothing";
}

TEST(CapsuleContacts, TheRecordedPairNeverExceedsItself) {
  CapsuleContacts capsules;
  const PairPose close = test::facing_pair(0.15);
  capsules.prepare(close, generic_capsule_radii(), generic_capsule_radii());
  const Measured m = measured(capsules, close);
  EXPECT_GT(m.deepest, 0.01);
  EXPECT_EQ(m.excess, 0);
  std::vector<ConstraintRow> rows;
  capsules.add_rows(close, rows);
  EXPECT_FALSE(rows.empty());
  for (const ConstraintRow& row : rows) EXPECT_GE(row.value(close), row.target - 1e-12);
}

TEST(CapsuleContacts, AClearanceIsAskedForBeyondWhatTheRecordingHas) {
  CapsuleContacts capsules;
  const PairPose close = test::facing_pair(0.15);
  capsules.prepare(close, generic_capsule_radii(), generic_capsule_radii(), 0.02);
  EXPECT_NEAR(capsules.deepest_excess_m(close), 0.02, 1e-12);
  EXPECT_EQ(measured(capsules, close).excess, 0) << "what is measured is beside the recording";
}

TEST(CapsuleContacts, BodiesArePushedBackToTheSideOnWhichTheyAreShown) {
  CapsuleRadii radii{};
  radii[upper_back_bone] = 0.15;
  const PairPose recorded = test::facing_pair(1), shown = test::facing_pair(-0.4),
                 now = test::facing_pair(-0.1);
  const auto push = [&](CapsuleContacts& capsules) {
    std::vector<ConstraintRow> rows;
    capsules.add_rows(now, rows);
    return rows.empty() ? Vec3(Vec3::Zero()) : rows.front().direction;
  };
  CapsuleContacts by_recording, by_shown;
  by_recording.prepare(recorded, radii, radii);
  by_shown.prepare(recorded, radii, radii);
  by_shown.keep_sides_of(shown);
  EXPECT_LT(push(by_recording).dot(push(by_shown)), -0.9);
}

TEST(CapsuleContacts, MeetingTheRowsTakesTheOverlapAway) {
  CapsuleContacts capsules;
  capsules.prepare(test::facing_pair(0.8), generic_capsule_radii(), generic_capsule_radii());
  PairPose pose = test::facing_pair(0.3);
  // Pushing the passive body away by what the most violated row misses.
  for (int turn = 0; turn < 40; ++turn) {
    std::vector<ConstraintRow> rows;
    capsules.add_rows(pose, rows);
    double missing = 0;
    for (const ConstraintRow& row : rows) missing = std::max(missing, row.target - row.value(pose));
    if (missing <= 0) break;
    pose.bottomRows<joint_count>().col(2).array() += missing;
  }
  EXPECT_LT(measured(capsules, pose).excess, 1e-3);
}

TEST(CapsuleContacts, AtMostSixteenRowsAndTheDeepestAreAmongThem) {
  CapsuleContacts capsules;
  capsules.prepare(test::facing_pair(3.0), generic_capsule_radii(), generic_capsule_radii());
  PairPose inside_one_another = test::facing_pair(0.02);
  std::vector<ConstraintRow> rows;
  capsules.add_rows(inside_one_another, rows);
  EXPECT_EQ(rows.size(), static_cast<std::size_t>(CapsuleContacts::max_rows));
  double most = 0;
  for (const ConstraintRow& row : rows) most = std::max(most, row.target - row.value(inside_one_another));
  EXPECT_NEAR(most, measured(capsules, inside_one_another).excess, 0.25);
}

TEST(CapsuleContacts, HandsThatHoldOneAnotherAreLeftAlone) {
  PairPose holding = test::facing_pair(0.66);  // hands of the standing poses meet in the middle
  ASSERT_LT((holding.row(joints::left_hand) - holding.row(joints::right_hand + joint_count)).norm(), 0.13);
  CapsuleContacts capsules;
  capsules.prepare(holding, generic_capsule_radii(), generic_capsule_radii());
  PairPose deeper = holding;
  deeper.row(joints::right_hand + joint_count) = holding.row(joints::left_hand);
  std::vector<ConstraintRow> rows;
  capsules.add_rows(deeper, rows);
  for (const ConstraintRow& row : rows) {
    const bool hands =
        row.vertices[1] == joints::left_hand && row.vertices[3] == joints::right_hand + joint_count;
    EXPECT_FALSE(hands);
  }
}

TEST(CapsuleContacts, ACapsuleThatWentThroughIsPushedBackToItsSide) {
  CapsuleRadii radii{};
  radii[upper_back_bone] = 0.1;
  CapsuleContacts capsules;
  capsules.prepare(test::facing_pair(0.5), radii, radii);
  const PairPose through = test::facing_pair(-0.05);  // the passive body has passed the active one
  std::vector<ConstraintRow> rows;
  capsules.add_rows(through, rows);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_LT(rows[0].coefficient(0).z() + rows[0].coefficient(1).z(), 0)
      << "the active body belongs on the -Z side";
}

}  // namespace
}  // namespace abrazo::capsule_contacts_test
