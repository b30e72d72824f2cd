#include "core/motion/joints/joint_guess.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/motion/files/import_clip.hpp"
#include "tests/core/motion/motion_fixtures.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::joint_guess_test {
namespace {

/// A standing person whose points are named so that no built-in map fits.
NamedMotion strangely_named() {
  NamedMotion motion;
  motion.name = "stranger";
  motion.fps = 60;
  const std::array<const char*, joint_count> names = {"Body_Hips_Centre",
                                                      "thigh.L",
                                                      "shin.L",
                                                      "foot.L",
                                                      "toe.L",
                                                      "p5",
                                                      "thigh.R",
                                                      "shin.R",
                                                      "foot.R",
                                                      "toe.R",
                                                      "p10",
                                                      "p11",
                                                      "Chest",
                                                      "p13",
                                                      "Neck",
                                                      "p15",
                                                      "Head",
                                                      "upper_arm.L",
                                                      "forearm.L",
                                                      "wrist.L",
                                                      "p20",
                                                      "upper_arm.R",
                                                      "forearm.R",
                                                      "wrist.R",
                                                      "p24"};
  for (const char* name : names) motion.points.emplace_back(name), motion.parents.push_back(-1);
  for (int f = 0; f < 10; ++f)
    motion.frames.push_back(Positions(test::moved(test::standing_pose(), 0.05 * f, Vec3(2, 0, 1))));
  return motion;
}

TEST(JointGuess, GoesByNamesOfAnyStyleAndBySide) {
  const NamedMotion motion = strangely_named();
  const JointGuess guess = guess_joints(motion, 0);
  const auto point = [&](int joint) {
    const auto& rules = guess.map.rules[static_cast<std::size_t>(joint)];
    return rules.empty() ? "" : rules.front().terms.front().point;
  };
  EXPECT_EQ(point(joints::left_hip), "thigh.L");
  EXPECT_EQ(point(joints::right_knee), "shin.R");
  EXPECT_EQ(point(joints::left_elbow), "forearm.L");
  EXPECT_EQ(point(joints::right_wrist), "wrist.R");
  EXPECT_EQ(point(joints::LowerNeck), "Neck");
  EXPECT_EQ(guess.by[joints::left_hip], JointGuess::By::Name);
}

TEST(JointGuess, GoesByPlaceWhereNamesSayNothing) {
  const NamedMotion motion = strangely_named();
  const JointGuess guess = guess_joints(motion, 4);
  EXPECT_EQ(guess.by[joints::LowerBack], JointGuess::By::Place);
  EXPECT_EQ(guess.map.rules[joints::LowerBack].front().terms.front().point, "p11");
  EXPECT_EQ(guess.map.rules[joints::right_toe_tip].front().terms.front().point, "p10");
}

TEST(JointGuess, EstimatesWhatIsLeftFromItsNeighbours) {
  NamedMotion motion = strangely_named();
  for (std::string& point : motion.points)
    if (point[0] == 'p') point = "";
  for (Positions& frame : motion.frames)
    for (Eigen::Index p = 0; p < frame.rows(); ++p)
      if (motion.points[static_cast<std::size_t>(p)].empty()) frame.row(p).setConstant(1e6);
  JointGuess guess = guess_joints(motion, 0);
  EXPECT_FALSE(estimate_missing_joints(guess.map).empty());
  ImportOptions options;
  options.joint_map = guess.map;
  const auto clip = import_clip(motion, options);
  ASSERT_TRUE(clip) << clip.error().text();
  for (int joint = 0; joint < joint_count; ++joint)
    EXPECT_LT((clip->clip.poses[0].row(joint) - motion.frames[0].row(joint)).norm(), 1e7);
  // A hand 1.28 forearms from the elbow.
  const Pose& pose = clip->clip.poses[0];
  EXPECT_LT(
      (pose.row(joints::left_hand) -
       (pose.row(joints::left_elbow) + 1.28 * (pose.row(joints::left_wrist) - pose.row(joints::left_elbow))))
          .norm(),
      1e-12);
}

TEST(JointMaps, AreWrittenAsTheyAreRead) {
  JointMap map = builtin_joint_maps()[2];
  map.rules[3] = {JointRule{{{"a \"b\"", 0.25}, {"c", 0.75}}}, JointRule{{{"d", 1.0}}}};
  const auto read = parse_joint_map(joint_map_json(map), "map.json");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(joint_map_json(*read), joint_map_json(map));
  EXPECT_EQ(read->rules[3].front().terms[1].weight, 0.75);
}

}  // namespace
}  // namespace abrazo::joint_guess_test
