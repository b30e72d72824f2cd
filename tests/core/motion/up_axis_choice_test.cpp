#include "core/motion/files/up_axis_choice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/motion/files/import_clip.hpp"
#include "tests/core/motion/motion_fixtures.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::up_axis_choice_test {
namespace {

using test::has_warning;
using test::the_warning;
using ::testing::HasSubstr;

/// A person who stands on a floor at 0.
Pose standing() {
  return test::moved(test::standing_pose(), 0.3, Vec3(1.0, 0, 2.0));
}

/// Head down, with the stretched arms on the floor.
Pose handstand() {
  Pose pose = test::standing_pose();
  for (const int side : {0, 1}) {
    const auto arm = side == 0 ? std::array{joints::left_elbow, joints::left_wrist, joints::left_hand}
                               : std::array{joints::right_elbow, joints::right_wrist, joints::right_hand};
    double height = 1.65;
    for (const int joint : arm)
      pose.row(joint) = Eigen::RowVector3d(side == 0 ? 0.2 : -0.2, height += 0.2, 0);
  }
  pose.col(1) = 2.30 - pose.col(1).array();
  pose.col(2) *= -1;
  return pose;
}

/// On the back, the head towards Z.
Pose lying() {
  Pose pose = test::standing_pose();
  const Eigen::VectorXd along = pose.col(1);
  pose.col(1) = 0.35 - pose.col(2).array();
  pose.col(2) = along.array() + 3.0;
  return pose;
}

/// As it is in a file in which `up` points up.
std::vector<Pose> in_file(std::vector<Pose> poses, UpAxis up) {
  for (Pose& pose : poses) turn_from_y_up(pose, up);
  return poses;
}

std::vector<Pose> frames(int standing_ones, int others, const Pose& other) {
  std::vector<Pose> poses(static_cast<std::size_t>(standing_ones), standing());
  poses.insert(poses.end(), static_cast<std::size_t>(others), other);
  return poses;
}

NamedMotion motion_of(const std::vector<Pose>& poses, std::optional<UpAxis> stated) {
  NamedMotion motion;
  motion.name = "someone";
  motion.fps = 60, motion.metres_per_unit = 1, motion.up_axis = stated;
  for (std::size_t j = 0; j < joint_count; ++j) {
    motion.points.emplace_back(joint_names[j]);
    motion.parents.push_back(joint_parents[j]);
  }
  for (const Pose& pose : poses) motion.frames.emplace_back(pose);
  return motion;
}

TEST(UpAxis, TurnsEveryAxisToYAndBackExactly) {
  for (const UpAxis up : every_up_axis) {
    Pose pose = standing();
    turn_from_y_up(pose, up);
    const auto [column, sign] = column_of(up);
    EXPECT_EQ(sign * pose(joints::Head, column), standing()(joints::Head, 1)) << name_of(up);
    turn_to_y_up(pose, up);
    EXPECT_EQ(pose, standing()) << name_of(up);
    Eigen::Matrix<double, 3, 3, Eigen::RowMajor> axes = Eigen::Matrix3d::Identity();
    turn_to_y_up(axes, up);
    EXPECT_EQ(axes.determinant(), 1.0) << "no mirror: " << name_of(up);
    EXPECT_EQ(find_up_axis(name_of(up)), up);
    EXPECT_EQ(opposite(opposite(up)), up);
  }
  EXPECT_FALSE(find_up_axis("w"));
  EXPECT_EQ(up_axis_names(), "y, z, -y, -z, x or -x");
}

TEST(UpAxisChoice, HoldsToWhatTheFileStatesIfAPersonStandsSo) {
  for (const UpAxis up : every_up_axis) {
    const UpAxisChoice choice = choose_up_axis(up, in_file(frames(10, 0, {}), up));
    EXPECT_EQ(choice.axis, up) << name_of(up);
    EXPECT_FALSE(choice.guessed);
    EXPECT_FALSE(choice.warning);
  }
}

/// A file of a real system names -Z, and its people stand along Z on plates at 0.
TEST(UpAxisChoice, APersonWhoStandsOverrulesTheAxisOfTheFileWithACountedQuestion) {
  for (const UpAxis up : {UpAxis::Y, UpAxis::Z, UpAxis::MinusY, UpAxis::MinusZ})
    for (const UpAxis stated : every_up_axis) {
      if (stated == up) continue;
      const UpAxisChoice choice = choose_up_axis(stated, in_file(frames(10, 1, lying()), up));
      EXPECT_EQ(choice.axis, up) << "stated " << name_of(stated);
      EXPECT_TRUE(choice.guessed);
      ASSERT_TRUE(choice.warning);
      EXPECT_EQ(choice.warning->kind, "up-axis");
      EXPECT_EQ(choice.warning->hint, Hint::SetUpAxis);
      EXPECT_TRUE(choice.warning->asks);
      EXPECT_THAT(choice.warning->detail, HasSubstr("in 10 of 11 frames"));
    }
  EXPECT_EQ(
      choose_up_axis(UpAxis::MinusZ, in_file(frames(4, 0, {}), UpAxis::Z)).warning->detail,
      "the file says that -Z points up, but the head is above the hips and the hips above the feet along Z "
      "in 4 of 4 frames; Z was taken, say the axis if that is wrong");
}

TEST(UpAxisChoice, AHandstandOrSomebodyOnTheFloorForMostOfATakeTurnsNothingOver) {
  for (const Pose& other : {handstand(), lying()})
    for (const UpAxis up : every_up_axis) {
      const UpAxisChoice choice = choose_up_axis(up, in_file(frames(2, 8, other), up));
      EXPECT_EQ(choice.axis, up) << name_of(up);
      EXPECT_FALSE(choice.guessed);
      EXPECT_FALSE(choice.warning);
    }
  for (const Pose& other : {handstand(), lying()})
    EXPECT_EQ(choose_up_axis({}, frames(2, 8, other)).axis, UpAxis::Y) << "without a stated axis";
}

TEST(UpAxisChoice, AHandstandForAWholeTakeIsKeptAndAsked) {
  const auto poses = frames(0, 6, handstand());
  const UpAxisChoice stated = choose_up_axis(UpAxis::Z, in_file(poses, UpAxis::Z));
  EXPECT_EQ(stated.axis, UpAxis::Z);
  EXPECT_FALSE(stated.guessed);
  EXPECT_THAT(stated.warning->detail, HasSubstr("head down along Z in 6 of 6 frames"));
  EXPECT_TRUE(stated.warning->asks);
  const UpAxisChoice unstated = choose_up_axis({}, poses);
  EXPECT_EQ(unstated.axis, UpAxis::Y);
  EXPECT_TRUE(unstated.warning->asks);
}

TEST(UpAxisChoice, WhoLiesOnTheFloorForAWholeTakeLeavesTheStatedAxis) {
  const UpAxisChoice choice = choose_up_axis(UpAxis::Y, frames(0, 6, lying()));
  EXPECT_EQ(choice.axis, UpAxis::Y);
  EXPECT_FALSE(choice.warning);
}

TEST(UpAxisChoice, RaisedArmsAreNoHandstand) {
  // Standing with raised arms, in a file that is upside down: the feet are at 0, not the hands.
  Pose raised = handstand();
  raised.col(1) = 2.30 - raised.col(1).array();
  raised.col(2) *= -1;
  const UpAxisChoice choice = choose_up_axis(UpAxis::MinusZ, in_file({raised, raised}, UpAxis::Z));
  EXPECT_EQ(choice.axis, UpAxis::Z);
}

TEST(UpAxisChoice, TakesTheSpaceOfACameraWhereYPointsDown) {
  auto poses = in_file(frames(6, 0, {}), UpAxis::MinusY);
  for (Pose& pose : poses) pose.rowwise() += Eigen::RowVector3d(0.1, 0.7, 3.5);
  const UpAxisChoice choice = choose_up_axis({}, poses);
  EXPECT_EQ(choice.axis, UpAxis::MinusY);
  EXPECT_TRUE(choice.guessed);
  EXPECT_TRUE(choice.warning->asks);
  for (const UpAxis unusual : {UpAxis::MinusZ, UpAxis::X, UpAxis::MinusX})
    EXPECT_EQ(choose_up_axis({}, in_file(frames(6, 0, {}), unusual)).axis, unusual) << "stands on 0";
}

TEST(UpAxisChoice, WhatAPersonSaysWinsAlways) {
  const NamedMotion motion = motion_of(in_file(frames(4, 0, {}), UpAxis::Z), UpAxis::MinusZ);
  const auto found = import_clip(motion, {});
  ASSERT_TRUE(found);
  EXPECT_LT((found->clip.poses[0] - standing()).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(found->report.up_axis, UpAxis::Z);
  EXPECT_TRUE(found->report.up_axis_guessed);
  EXPECT_TRUE(found->report.asks());
  for (const UpAxis said : every_up_axis) {
    ImportOptions options;
    options.up_axis = said, options.floor_m = 0;
    const auto clip = import_clip(motion, options);
    ASSERT_TRUE(clip);
    Pose as_said = motion.frames[0];
    turn_to_y_up(as_said, said);
    EXPECT_EQ(clip->clip.poses[0], as_said) << name_of(said);
    EXPECT_EQ(clip->report.up_axis, said);
    EXPECT_FALSE(clip->report.up_axis_guessed);
    EXPECT_FALSE(has_warning(clip->report.warnings, "up-axis"));
  }
}

TEST(UpAxisChoice, PerformersOfAFileShareItAndWhoStandsDecides) {
  const auto two = [](const std::vector<Pose>& first, const std::vector<Pose>& second, UpAxis stated) {
    std::vector<NamedMotion> motions = {motion_of(first, stated), motion_of(second, stated)};
    motions[0].name = "first", motions[1].name = "second";
    ImportOptions options;
    options.floor_m = 0;  // of a handstand the toes do not rest on it
    return import_performers("pair.c3d", motions, options).value();
  };
  // Both upside down by the file: the second is turned as the first, and asked about once.
  const auto stand = in_file(frames(4, 0, {}), UpAxis::Z);
  auto clips = two(stand, in_file(frames(0, 4, lying()), UpAxis::Z), UpAxis::MinusZ);
  ASSERT_EQ(clips.size(), 2U);
  for (const ImportedClip& clip : clips) {
    EXPECT_EQ(clip.report.up_axis, UpAxis::Z);
    EXPECT_TRUE(clip.report.up_axis_guessed);
  }
  EXPECT_LT((clips[1].clip.poses[0] - lying()).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_TRUE(has_warning(clips[0].report.warnings, "up-axis"));
  EXPECT_FALSE(has_warning(clips[1].report.warnings, "up-axis"));
  // The first is on the hands: the second, who stands as stated, leaves no question.
  clips = two(in_file(frames(0, 4, handstand()), UpAxis::Z), stand, UpAxis::Z);
  for (const ImportedClip& clip : clips) {
    EXPECT_EQ(clip.report.up_axis, UpAxis::Z);
    EXPECT_FALSE(clip.report.up_axis_guessed);
    EXPECT_FALSE(has_warning(clip.report.warnings, "up-axis"));
  }
  EXPECT_LT((clips[0].clip.poses[0] - handstand()).cwiseAbs().maxCoeff(), 1e-12);
  // The first hangs head down with no floor to tell, and would be turned over.
  auto hanging = stand;
  for (Pose& pose : hanging) pose = -pose, pose.col(2).array() += 4;
  EXPECT_EQ(two(hanging, hanging, UpAxis::Z)[0].report.up_axis, UpAxis::MinusZ);
  clips = two(hanging, stand, UpAxis::Z);
  EXPECT_EQ(clips[0].report.up_axis, UpAxis::Z);
  EXPECT_EQ(clips[1].report.up_axis, UpAxis::Z);
}

TEST(UpAxisChoice, AWarningOfTheReaderIsNoQuestion) {
  NamedMotion motion = motion_of(frames(3, 0, {}), UpAxis::Y);
  motion.warnings.push_back({"up-axis", 0, "..."});
  const auto clip = import_clip(motion, {});
  ASSERT_TRUE(clip);
  EXPECT_FALSE(clip->report.asks());
  EXPECT_EQ(the_warning(clip->report.warnings, "up-axis").detail, "...");
}

}  // namespace
}  // namespace abrazo::up_axis_choice_test
