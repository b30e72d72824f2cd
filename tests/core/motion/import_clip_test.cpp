#include "core/motion/files/import_clip.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "core/motion/body/body.hpp"
#include "tests/core/motion/motion_fixtures.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::import_clip_test {
namespace {

using test::has_warning;
using test::the_warning;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A person who stands, then sways a little, by the joint set's own names; `unit` file units per metre.
NamedMotion standing_motion(double units_per_metre = 1.0) {
  NamedMotion motion;
  motion.name = "someone";
  motion.fps = 60.0;
  for (std::size_t j = 0; j < joint_count; ++j) {
    motion.points.emplace_back(joint_names[j]);
    motion.parents.push_back(joint_parents[j]);
  }
  for (int f = 0; f < 5; ++f)
    motion.frames.emplace_back(test::moved(test::standing_pose(), 0.02 * f, Vec3(0.01 * f, 0, 0)) *
                               units_per_metre);
  return motion;
}

ImportedClip imported(const NamedMotion& motion, const ImportOptions& options = {}) {
  Result<ImportedClip> clip = import_clip(motion, options);
  if (clip) return std::move(*clip);
  ADD_FAILURE() << clip.error().text();
  return {};
}

TEST(ImportClip, GivesTheJointsOfTheFileInMetres) {
  const ImportedClip result = imported(standing_motion());
  EXPECT_EQ(result.clip.name, "someone");
  EXPECT_EQ(result.clip.fps, 60.0);
  EXPECT_EQ(result.report.joint_map, "cmu");
  ASSERT_EQ(result.clip.poses.size(), 5u);
  EXPECT_LT((result.clip.poses[0] - test::standing_pose()).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(result.report.floor_shift_m, 0.0);
  EXPECT_NEAR(result.report.floor_y_m, 0.04, 1e-12);
}

TEST(ImportClip, GuessesTheUnitFromTheHeightAndSaysSo) {
  for (const double metres_per_unit : {1.0, 0.01, 0.001, 0.0254, (1.0 / 0.45) * 2.54 / 100.0}) {
    SCOPED_TRACE(metres_per_unit);
    const ImportedClip result = imported(standing_motion(1.0 / metres_per_unit));
    EXPECT_DOUBLE_EQ(result.report.metres_per_unit, metres_per_unit);
    EXPECT_TRUE(result.report.unit_guessed);
    EXPECT_TRUE(has_warning(result.report.warnings, "units"));
    EXPECT_LT((result.clip.poses[0] - test::standing_pose()).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(ImportClip, AsksForWhatTheFileLeavesOpenOnly) {
  EXPECT_FALSE(imported(standing_motion(100)).report.asks()) << "only centimetres make an adult";
  EXPECT_TRUE(imported(standing_motion(5)).report.asks()) << "no unit does";
  NamedMotion without_rate = standing_motion();
  without_rate.fps.reset();
  EXPECT_TRUE(imported(without_rate).report.asks());
  without_rate.metres_per_unit = (1.0 / 0.45) * 2.54 / 100.0;
  for (Positions& frame : without_rate.frames) frame /= *without_rate.metres_per_unit;
  EXPECT_FALSE(imported(without_rate).report.asks()) << "CMU's rate is known";
  NamedMotion with_two = standing_motion();
  with_two.animations = {"walk", "run"};
  EXPECT_TRUE(imported(with_two).report.asks());
  ImportOptions said;
  said.fps = 60;
  EXPECT_FALSE(imported(without_rate, said).report.asks());
}

TEST(ImportClip, DoesNotGuessAUnitThatIsStated) {
  NamedMotion motion = standing_motion(100.0);
  motion.metres_per_unit = 0.01;
  EXPECT_FALSE(imported(motion).report.unit_guessed);
  EXPECT_NEAR(imported(motion).report.height_m, body_of(test::standing_pose()).height(), 1e-9);
  ImportOptions options;
  options.metres_per_unit = 0.005;  // the person knows better than the file
  EXPECT_DOUBLE_EQ(imported(motion, options).report.metres_per_unit, 0.005);
}

TEST(ImportClip, QuestionsAHeightNobodyHas) {
  ImportOptions options;
  options.metres_per_unit = 2.0;
  const ImportedClip result = imported(standing_motion(), options);
  EXPECT_EQ(the_warning(result.report.warnings, "height").hint, Hint::SetUnit);
  EXPECT_FALSE(has_warning(imported(standing_motion()).report.warnings, "height"));
}

TEST(ImportClip, CountsTheFramesThatCannotBeAPersons) {
  NamedMotion motion = standing_motion();
  for (int f = 0; f < 15; ++f) motion.frames.push_back(motion.frames.back());
  for (const std::size_t f : {12U, 13U})
    motion.frames[f].row(joints::LeftHand) += Eigen::RowVector3d(2e5, 0, 0);
  for (std::size_t f = 17; f < motion.frames.size(); ++f) motion.frames[f].col(0).array() += 3.0;
  const ImportedClip result = imported(motion);
  EXPECT_EQ(result.clip.poses.size(), 20u) << "they are kept";
  EXPECT_THAT(the_warning(result.report.warnings, "not-a-person").detail,
              HasSubstr("2 of 20 frames cannot be a person's; the first is frame 12: lhand is 2e+05 m away"));
  EXPECT_THAT(the_warning(result.report.warnings, "jumps").detail,
              HasSubstr("jumps in 1 of 20 frames faster than anybody moves; the first is frame 17"));
  EXPECT_FALSE(has_warning(imported(standing_motion()).report.warnings, "not-a-person"));
}

TEST(ImportClip, NumbersOfADamagedFileStayReadable) {
  NamedMotion motion = standing_motion();
  ImportOptions options;
  options.metres_per_unit = 40;
  EXPECT_THAT(the_warning(imported(motion, options).report.warnings, "not-a-person").detail,
              HasSubstr("Is the unit right? They are kept"));
  for (auto& frame : motion.frames) frame.array() += 1e5;
  const std::string floor = the_warning(imported(motion).report.warnings, "floor").detail;
  EXPECT_THAT(floor, HasSubstr("the toe bases rest at 100000.040 m;"));
}

TEST(ImportClip, TurnsZUpFilesToYUp) {
  NamedMotion motion = standing_motion();
  for (Positions& frame : motion.frames) {
    const Positions y_up = frame;  // (x, y, z) with Y up is (x, -z, y) with Z up
    frame.col(1) = -y_up.col(2);
    frame.col(2) = y_up.col(1);
  }
  const ImportedClip result = imported(motion);
  EXPECT_EQ(result.report.up_axis, UpAxis::Z);
  EXPECT_TRUE(result.report.up_axis_guessed);
  EXPECT_TRUE(has_warning(result.report.warnings, "up-axis"));
  EXPECT_LT((result.clip.poses[0] - test::standing_pose()).cwiseAbs().maxCoeff(), 1e-12);
  ImportOptions options;
  options.up_axis = UpAxis::Z;
  EXPECT_FALSE(imported(motion, options).report.up_axis_guessed);
  EXPECT_FALSE(has_warning(imported(motion, options).report.warnings, "up-axis"));
}

TEST(ImportClip, QuestionsThePersonWhoLies) {
  NamedMotion motion = standing_motion();
  for (Positions& frame : motion.frames) frame.col(0).swap(frame.col(1));
  EXPECT_TRUE(has_warning(imported(motion).report.warnings, "up-axis"));
}

TEST(ImportClip, WhoMostlyCrawlsStandsOnTheFloorThatLiesAtZero) {
  for (const bool z_up : {true, false}) {
    NamedMotion motion = standing_motion();
    motion.frames.clear();
    for (int f = 0; f < 10; ++f) {
      // Two metres from the origin; in seven of ten frames along the floor, which is where the axis may
      // point.
      Positions pose = f < 3 ? test::moved(test::standing_pose(), 0, Vec3(0, 0, -2)) : test::standing_pose();
      if (f >= 3) {
        const Eigen::VectorXd up = pose.col(1);
        pose.col(1) = pose.col(2).array() + 0.3;
        pose.col(2) = up.array() - 2;
      }
      if (z_up) pose.col(1).swap(pose.col(2));
      motion.frames.push_back(pose);
    }
    EXPECT_EQ(imported(motion).report.up_axis, z_up ? UpAxis::Z : UpAxis::Y);
  }
}

TEST(ImportClip, GuessesTheRateWhenTheFileDoesNotSayAndSaysSo) {
  NamedMotion motion = standing_motion();
  motion.fps.reset();
  const ImportedClip result = imported(motion);
  EXPECT_EQ(result.clip.fps, 120.0);
  EXPECT_TRUE(result.report.fps_guessed);
  EXPECT_EQ(the_warning(result.report.warnings, "fps").hint, Hint::SetFrameRate);
  ImportOptions options;
  options.fps = 50;
  EXPECT_EQ(imported(motion, options).clip.fps, 50.0);
  EXPECT_FALSE(imported(motion, options).report.fps_guessed);
}

TEST(ImportClip, ARateOrAPlaceBeyondReasonIsRefused) {
  const auto refused = [](const NamedMotion& motion) {
    const auto clip = import_clip(motion, {});
    return clip ? std::string() : clip.error().text();
  };
  NamedMotion motion = standing_motion();
  for (const double fps : {1e300, 10'001.0, 0.05}) {
    motion.fps = fps;
    EXPECT_THAT(refused(motion), HasSubstr("frames per second; expected 0.1 to 10000")) << fps;
  }
  for (const double fps : {0.1, 10'000.0}) {
    motion.fps = fps;
    EXPECT_EQ(refused(motion), "") << fps;
  }
  motion = standing_motion();
  motion.frames[3](7, 0) = 1e308;
  EXPECT_THAT(refused(motion), HasSubstr("frame 3 (counted from 0) has a joint more than 1000 km away"));
}

TEST(ImportClip, PutsAPersonFarFromTheFloorOntoItAndSaysSo) {
  for (const double height : {0.5, -0.3}) {
    NamedMotion motion = standing_motion();
    for (Positions& frame : motion.frames) frame.col(1).array() += height;
    const ImportedClip result = imported(motion);
    EXPECT_NEAR(result.report.floor_y_m, 0.04 + height, 1e-9);
    EXPECT_NEAR(result.report.floor_shift_m, -height, 1e-9);
    EXPECT_TRUE(has_warning(result.report.warnings, "floor"));
    EXPECT_LT((result.clip.poses[0] - test::standing_pose()).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(ImportClip, LeavesAFloorThatIsNearlyRight) {
  for (const double height : {0.15, -0.13}) {
    NamedMotion motion = standing_motion();
    for (Positions& frame : motion.frames) frame.col(1).array() += height;
    EXPECT_EQ(imported(motion).report.floor_shift_m, 0.0);
  }
}

TEST(ImportClip, ReportsAndKeepsAFirstFrameThatIsTheRestPose) {
  NamedMotion motion = standing_motion();
  EXPECT_FALSE(has_warning(imported(motion).report.warnings, "first-frame"));
  for (const int joint : {joints::left_elbow, joints::left_wrist, joints::left_hand, joints::right_elbow,
                          joints::right_wrist, joints::right_hand})
    motion.frames[0].row(joint) += Eigen::RowVector3d(joint < joints::RightClavicle ? 0.3 : -0.3, 0.4, 0);
  const ImportedClip result = imported(motion);
  EXPECT_TRUE(has_warning(result.report.warnings, "first-frame"));
  EXPECT_EQ(result.clip.poses.size(), 5u);
}

TEST(ImportClip, KeepsTheReadersWarnings) {
  NamedMotion motion = standing_motion();
  motion.warnings.push_back({"glued-numbers", 7, "..."});
  EXPECT_EQ(the_warning(imported(motion).report.warnings, "glued-numbers").line, 7);
}

TEST(ImportClip, NamesWhatTheClosestMapLacks) {
  NamedMotion motion = standing_motion();
  motion.points[joints::Root] = "middle";
  const auto result = import_clip(motion, {});
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("no joint map fits; the closest, 'cmu', lacks root (root)."));
  EXPECT_EQ(result.error().hint, Hint::NameJointMap);
  EXPECT_THAT(result.error().message, HasSubstr("middle, lhipjoint"));
  EXPECT_THAT(result.error().message, HasSubstr("and 19 more")) << "of 25 points";
}

TEST(ImportClip, UsesOnlyTheMapItIsGiven) {
  ImportOptions options;
  options.joint_map = builtin_joint_maps()[2];
  const auto result = import_clip(standing_motion(), options);
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("the joint map 'mixamo' does not fit"));
}

TEST(ImportClip, RefusesPositionsThatAreNotFinite) {
  NamedMotion motion = standing_motion();
  motion.frames[3](joints::left_hand, 1) = std::numeric_limits<double>::quiet_NaN();
  const auto result = import_clip(motion, {});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().where, "someone: frame 3");
  EXPECT_THAT(result.error().message, HasSubstr("lhand"));
}

TEST(ImportClip, RefusesOptionsThatMakeNoSense) {
  ImportOptions options;
  options.metres_per_unit = 0.0;
  EXPECT_FALSE(import_clip(standing_motion(), options));
  options = {};
  options.fps = -1.0;
  EXPECT_FALSE(import_clip(standing_motion(), options));
  NamedMotion empty = standing_motion();
  empty.frames.clear();
  EXPECT_FALSE(import_clip(empty, {}));
}

}  // namespace
}  // namespace abrazo::import_clip_test
