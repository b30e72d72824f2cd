#include <stdexcept>
#include <string>

#include "core/motion/body/body_segments.hpp"

#include <gtest/gtest.h>

#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::body_segments_test {
namespace {

const BodySegment& named(const std::array<BodySegment, segment_count>& segments, std::string_view name) {
  for (const BodySegment& segment : segments)
    if (segment.name == name) return segment;
  throw std::invalid_argument("no such segment");
}

TEST(BodySegments, MakeUpTheWholeBody) {
  for (const SegmentTable table : {SegmentTable::Male, SegmentTable::Female, SegmentTable::Mean}) {
    double mass = 0;
    for (const BodySegment& segment : body_segments(table)) mass += segment.mass;
    EXPECT_NEAR(mass, 1, 2e-4) << "the table is rounded to four digits";
  }
}

TEST(BodySegments, AreTheSameOnBothSides) {
  const auto segments = body_segments(SegmentTable::Female);
  int sides = 0;
  for (const BodySegment& left : segments) {
    if (!left.name.starts_with("left ")) continue;
    ++sides;
    const BodySegment& right = named(segments, "right " + std::string(left.name.substr(5)));
    EXPECT_EQ(left.mass, right.mass) << left.name;
    EXPECT_EQ(left.centre, right.centre) << left.name;
    for (const std::size_t end : {0, 1}) {
      EXPECT_EQ(mirrored_joint(left.proximal[end]), right.proximal[end]) << left.name;
      EXPECT_EQ(mirrored_joint(left.distal[end]), right.distal[end]) << left.name;
    }
  }
  EXPECT_EQ(sides, 6);
}

TEST(BodySegments, MeanLiesBetweenMenAndWomen) {
  const BodySegment thigh = named(body_segments(SegmentTable::Mean), "left thigh");
  EXPECT_NEAR(thigh.mass, 0.5 * (0.1416 + 0.1478), 1e-12);
  EXPECT_NEAR(thigh.centre, 0.5 * (0.4095 + 0.3612), 1e-12);
}

TEST(BodySegments, CentreOfTheTrunkLiesBetweenMiddleOfShouldersAndMiddleOfHips) {
  Pose pose = Pose::Zero();
  pose.row(joints::left_shoulder) << 0.3, 1.4, 0;
  pose.row(joints::right_shoulder) << -0.1, 1.4, 0.2;
  pose.row(joints::left_hip) << 0.1, 0.9, 0;
  pose.row(joints::right_hip) << -0.1, 0.9, 0;
  const Vec3 centre = segment_centre(named(body_segments(SegmentTable::Male), "trunk"), pose);
  EXPECT_LT((centre - Vec3(0.569 * 0.1, 1.4 - 0.431 * 0.5, 0.569 * 0.1)).norm(), 1e-12);
}

TEST(BodySegments, CentreOfTheForearmIsNearerTheElbow) {
  Pose pose = Pose::Zero();
  pose.row(joints::left_elbow) << 0, 1, 0;
  pose.row(joints::left_wrist) << 0, 1, 1;
  const Vec3 centre = segment_centre(named(body_segments(SegmentTable::Male), "left forearm"), pose);
  EXPECT_LT((centre - Vec3(0, 1, 0.4574)).norm(), 1e-12);
}

TEST(BodySegments, CentreOfMassOfAStandingAdultIsALittleAboveTheHips) {
  const Vec3 centre = centre_of_mass(body_segments(SegmentTable::Mean), test::standing_pose());
  EXPECT_NEAR(centre.y() / 1.75, 0.56, 0.02) << "56 % of the height";
  EXPECT_NEAR(centre.x(), 0, 1e-9);
}

}  // namespace
}  // namespace abrazo::body_segments_test
