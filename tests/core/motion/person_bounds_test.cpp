#include "core/motion/body/person_bounds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "core/choreography/salsa.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/motion/files/import_clip.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/captured_data.hpp"

namespace abrazo::person_bounds_test {
namespace {

using testing::HasSubstr;
using namespace joints;

std::string reason(const Pose& pose) {
  const auto doubt = why_not_a_person(pose);
  return doubt ? std::string(doubt->sentence()) : "a person";
}

/// Every joint anywhere in a cube.
Pose random_points(double side_m, std::mt19937& random) {
  std::uniform_real_distribution<double> place(0, side_m);
  Pose pose;
  for (int j = 0; j < joint_count; ++j)
    for (int axis = 0; axis < 3; ++axis) pose(j, axis) = place(random);
  return pose;
}

TEST(PersonBounds, PeopleOfAnySizeAndPlaceArePeople) {
  const Pose adult = test::standing_pose();
  for (const double size : {0.3, 0.5, 1.0, 1.55, 2.5}) EXPECT_EQ(reason(size * adult), "a person") << size;
  EXPECT_EQ(reason(test::moved(adult, 1, Vec3(500, 3, -500))), "a person") << "a hall, a trapeze";
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i)
    EXPECT_EQ(reason(test::shaken(adult, 0.03, random)), "a person") << "jitter of three centimetres";
}

TEST(PersonBounds, ALostJointIsNamedWithWhatWasExpected) {
  Pose pose = test::standing_pose();
  pose.row(LeftWrist) += Eigen::RowVector3d(45, 0, 0);
  EXPECT_THAT(reason(pose), HasSubstr("lwrist is 45"));
  EXPECT_THAT(reason(pose), HasSubstr("no bone of a person is longer than 2.00 m"));
  for (const double far :
       {2e5, 1e308, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    pose(Head, 1) = far;
    EXPECT_THAT(reason(pose), HasSubstr("head is")) << far;
  }
}

TEST(PersonBounds, OnePointIsNoPerson) {
  const Pose point = Pose::Constant(1.0);
  EXPECT_THAT(reason(point), HasSubstr("all bones together are 0.00 m long"));
}

TEST(PersonBounds, AWrongUnitAndAWrongFloorAreAskedFor) {
  EXPECT_THAT(reason(100 * test::standing_pose()), HasSubstr("Is the unit right?"));
  EXPECT_THAT(reason(0.01 * test::standing_pose()), HasSubstr("Is the unit right?"));
  EXPECT_THAT(reason(test::moved(test::standing_pose(), 0, Vec3(0, 100, 0))),
              HasSubstr("nobody dances beyond 10.00 m. Is the floor where it should be?"));
}

TEST(PersonBounds, PointsAtRandomAreNoPeople) {
  std::mt19937 random(7);
  for (const double side_m : {0.2, 0.5, 1.0, 2.0, 10.0, 1000.0}) {
    int people = 0;
    for (int i = 0; i < 2000; ++i) people += !why_not_a_person(random_points(side_m, random));
    EXPECT_LE(people, 100) << "of 2000 in a cube of " << side_m << " m";
  }
}

TEST(PersonBounds, NobodyMovesFasterThanTwentyMetresASecond) {
  const Pose here = test::standing_pose();
  const auto moved = [&](double by_m) { return test::moved(here, 0, Vec3(by_m, 0, 0)); };
  EXPECT_FALSE(is_jump_beyond_a_person(here, moved(0.3), 1.0 / 60));
  EXPECT_TRUE(is_jump_beyond_a_person(here, moved(0.4), 1.0 / 60));
  EXPECT_FALSE(is_jump_beyond_a_person(here, moved(0.09), 1.0 / 1000)) << "jitter at a high rate";
  EXPECT_TRUE(is_jump_beyond_a_person(here, moved(1e308), 1));
}

TEST(PersonBounds, DoubtsOfAClipAreCountedWithTheFirstFrameOfEach) {
  std::vector<Pose> poses(20, test::standing_pose());
  poses[5] = poses[6] = Pose::Zero();
  for (std::size_t f = 10; f < poses.size(); ++f) poses[f] = test::moved(poses[f], 0, Vec3(3, 0, 0));
  const PersonDoubts doubts = person_doubts(poses, 60);
  EXPECT_EQ(doubts.poses, 2U);
  EXPECT_EQ(doubts.first_pose, 5U);
  EXPECT_THAT(doubts.first_reason, HasSubstr("all bones together"));
  EXPECT_EQ(doubts.jumps, 1U) << "to where nobody is and back is no jump";
  EXPECT_EQ(doubts.first_jump, 10U);
}

TEST(PersonBounds, NothingOfTheCapturesIsDoubted) {
  ABRAZO_REQUIRE_CAPTURED_DATA(data);
  std::size_t frames = 0;
  ImportOptions options;
  options.fps = 120;
  for (const std::string performer : {"60", "61"})
    for (const char* take : {"01", "02", "03", "05", "06", "07", "09", "10", "12", "13", "14"}) {
      const auto loaded =
          load_motion((data / "cmu_salsa" / (performer + "_" + take + ".amc")).string(), "", options);
      ASSERT_TRUE(loaded) << loaded.error().text();
      const Clip& clip = loaded->front().clip;
      const PersonDoubts doubts = person_doubts(clip.poses, clip.fps);
      EXPECT_EQ(doubts.poses + doubts.jumps, 0U) << clip.name << ": " << doubts.first_reason;
      frames += clip.poses.size();
    }
  EXPECT_GT(frames, 40'000U);
}

}  // namespace
}  // namespace abrazo::person_bounds_test
