#include "core/motion/acclaim/asf_amc.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <random>

#include "tests/core/motion/motion_fixtures.hpp"

namespace abrazo::asf_amc_test {
namespace {

using test::expect_near;
using test::fixture_text;
using test::place;
using test::the_warning;
using ::testing::HasSubstr;

Eigen::Matrix3d about(int axis, double degrees) {
  return Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, Vec3::Unit(axis)).toRotationMatrix();
}
Eigen::Matrix3d xyz(double x, double y, double z) {
  return about(2, z) * about(1, y) * about(0, x);
}
Eigen::Matrix3d zyx(double x, double y, double z) {
  return about(0, x) * about(1, y) * about(2, z);
}

Result<NamedMotion> read(const std::string& asf, const std::string& amc) {
  return read_asf_amc(fixture_text(asf), asf, fixture_text(amc), amc);
}

NamedMotion must_read(const std::string& asf, const std::string& amc) {
  Result<NamedMotion> motion = read(asf, amc);
  if (motion) return std::move(*motion);
  ADD_FAILURE() << motion.error().text();
  return {};
}

/// Bone lengths and axes as in leg.asf, angles as in leg.amc.
struct Leg {
  Vec3 hip, shin, foot;
};
Leg leg(const Vec3& root, const Eigen::Matrix3d& turn, double shin_x, double foot_x, double foot_z) {
  const Eigen::Matrix3d shin_axis = xyz(0, 0, 20), foot_axis = xyz(-90, 0, 20);
  const Eigen::Matrix3d shin = turn * shin_axis * xyz(shin_x, 0, 0) * shin_axis.transpose();
  const Eigen::Matrix3d foot = shin * foot_axis * xyz(foot_x, 0, foot_z) * foot_axis.transpose();
  Leg result;
  result.hip = root + turn * Vec3(2, 0, 0);
  result.shin = result.hip + shin * Vec3(0, -7, 0);
  result.foot = result.shin + foot * Vec3(0, 0, 2);
  return result;
}

void expect_frame(const NamedMotion& motion, std::size_t frame, const Leg& expected) {
  expect_near(place(motion, frame, "hip"), expected.hip);
  expect_near(place(motion, frame, "shin"), expected.shin);
  expect_near(place(motion, frame, "foot"), expected.foot);
}

void expect_the_leg(const NamedMotion& motion) {
  ASSERT_EQ(motion.frames.size(), 3u);
  expect_near(place(motion, 1, "root"), Vec3(1, 2, 4));
  expect_frame(motion, 0, leg({1, 2, 3}, xyz(10, 20, 30), 40, 50, 60));
  expect_frame(motion, 1, leg({1, 2, 4}, xyz(-10, -20, -30), -40, -50, -60));
  expect_frame(motion, 2, leg({1, 2, 5}, xyz(0, 0, 0), 0, 0, 0));
}

TEST(AsfAmc, TurnsEachBoneAboutItsOwnAxes) {
  const NamedMotion motion = must_read("leg.asf", "leg.amc");
  expect_the_leg(motion);
  EXPECT_THAT(motion.warnings, testing::IsEmpty());
  EXPECT_EQ(motion.name, "leg");
}

TEST(AsfAmc, PutsParentsFirstWhateverTheOrderOfBonedata) {
  const NamedMotion motion = must_read("leg.asf", "leg.amc");
  EXPECT_THAT(motion.points, testing::ElementsAre("root", "hip", "shin", "foot"));
  EXPECT_EQ(motion.parents, (std::vector<int>{-1, 0, 1, 2}));
}

TEST(AsfAmc, LeavesTheRateOpenAndTakesTheUnitFromTheSkeleton) {
  const NamedMotion motion = must_read("leg.asf", "leg.amc");
  EXPECT_EQ(motion.fps, std::nullopt);
  EXPECT_NEAR(motion.metres_per_unit.value_or(0), 0.0564444444, 1e-9);
  EXPECT_EQ(must_read("leg_no_unit.asf", "leg.amc").metres_per_unit, std::nullopt);
}

TEST(AsfAmc, ObeysRadiansInSkeletonAndMotion) {
  expect_the_leg(must_read("leg_radians.asf", "leg_radians.amc"));
  const NamedMotion mixed = must_read("leg_radians.asf", "leg.amc");
  expect_the_leg(mixed);
  EXPECT_EQ(the_warning(mixed.warnings, "angle-unit").line, 3);
}

TEST(AsfAmc, ObeysTheOrderOfTheAxes) {
  const NamedMotion motion = must_read("leg_zyx.asf", "leg.amc");
  const Eigen::Matrix3d shin_axis = zyx(0, 0, 20), foot_axis = zyx(30, 40, 50);
  const Eigen::Matrix3d shin = xyz(10, 20, 30) * shin_axis * zyx(40, 0, 0) * shin_axis.transpose();
  const Eigen::Matrix3d foot = shin * foot_axis * zyx(50, 0, 60) * foot_axis.transpose();
  expect_near(place(motion, 0, "foot") - place(motion, 0, "shin"), foot * Vec3(0, 0, 2));
}

TEST(AsfAmc, ObeysTheOrderOfTheRootsValues) {
  const NamedMotion motion = must_read("leg_root_order.asf", "leg_root_order.amc");
  expect_near(place(motion, 0, "root"), Vec3(1, 2, 3));
  expect_frame(motion, 0, leg({1, 2, 3}, xyz(10, 20, 30), 40, 50, 60));
}

TEST(AsfAmc, ReadsCrlfAndComments) {
  expect_the_leg(must_read("leg.asf", "leg_crlf.amc"));
  expect_the_leg(must_read("leg.asf", "leg_comments.amc"));
  std::string asf = fixture_text("leg.asf");
  for (std::size_t at = 0; (at = asf.find('\n', at)) != std::string::npos; at += 2) asf.insert(at, 1, '\r');
  const auto motion = read_asf_amc(asf, "leg.asf", fixture_text("leg_crlf.amc"), "leg.amc");
  ASSERT_TRUE(motion) << motion.error().text();
  expect_the_leg(*motion);
}

TEST(AsfAmc, HoldsABoneThatIsMissingInAFrameAndSaysSo) {
  const NamedMotion motion = must_read("leg.asf", "leg_missing_bone.amc");
  ASSERT_EQ(motion.frames.size(), 3u);
  expect_frame(motion, 1, leg({1, 2, 4}, xyz(-10, -20, -30), 40, -50, -60));
  const ImportWarning warning = the_warning(motion.warnings, "missing-bone");
  EXPECT_EQ(warning.line, 8);
  EXPECT_THAT(warning.detail, HasSubstr("'shin' has no values in 1 of 3 frames, first in frame 2"));
}

TEST(AsfAmc, KeepsABoneAtRestThatIsNeverGivenAndSaysSo) {
  const NamedMotion motion = must_read("leg.asf", "leg_never_given.amc");
  expect_frame(motion, 0, leg({1, 2, 3}, xyz(10, 20, 30), 0, 50, 60));
  EXPECT_THAT(the_warning(motion.warnings, "missing-bone").detail,
              HasSubstr("'shin' has no values in any frame"));
}

TEST(AsfAmc, NamesTheLineWithAWrongNumberOfValues) {
  const auto motion = read("leg.asf", "leg_wrong_count.amc");
  ASSERT_FALSE(motion);
  EXPECT_EQ(motion.error().where, "leg_wrong_count.amc:11");
  EXPECT_THAT(motion.error().message, HasSubstr("expected 2 values for 'foot'"));
  EXPECT_THAT(motion.error().message, HasSubstr("found 1"));
}

TEST(AsfAmc, ReportsFrameNumbersThatJump) {
  const NamedMotion motion = must_read("leg.asf", "leg_jump.amc");
  expect_the_leg(motion);
  const ImportWarning warning = the_warning(motion.warnings, "frame-number");
  EXPECT_EQ(warning.line, 8);
  EXPECT_THAT(warning.detail, HasSubstr("1 time(s)"));
}

TEST(AsfAmc, KeepsTheWholeFramesOfAMotionThatWasCutOff) {
  for (const char* name : {"leg_truncated.amc", "leg_truncated_between_lines.amc"}) {
    SCOPED_TRACE(name);
    const NamedMotion motion = must_read("leg.asf", name);
    EXPECT_EQ(motion.frames.size(), 2u);
    EXPECT_EQ(the_warning(motion.warnings, "truncated").line, 12);
    EXPECT_FALSE(test::has_warning(motion.warnings, "missing-bone"));
  }
}

TEST(AsfAmc, RefusesABoneTheSkeletonDoesNotHave) {
  const auto motion = read("leg.asf", "leg_unknown_bone.amc");
  ASSERT_FALSE(motion);
  EXPECT_EQ(motion.error().where, "leg_unknown_bone.amc:10");
  EXPECT_THAT(motion.error().message, HasSubstr("no bone 'tail'"));
}

TEST(AsfAmc, NamesLineAndFrameOfWhatIsNotANumber) {
  const auto motion = read("leg.asf", "leg_nan.amc");
  ASSERT_FALSE(motion);
  EXPECT_EQ(motion.error().where, "leg_nan.amc:10");
  EXPECT_THAT(motion.error().message, HasSubstr("frame 2: expected a number for 'shin', found 'nan'"));
}

TEST(AsfAmc, SaysWhatIsWrongWithASkeletonItCannotUse) {
  EXPECT_EQ(read("leg_two_parents.asf", "leg.amc").error().where, "leg_two_parents.asf:47");
  EXPECT_THAT(read("leg_two_parents.asf", "leg.amc").error().message,
              HasSubstr("'foot' already has the parent 'shin'"));
  EXPECT_THAT(read("leg_unjoined.asf", "leg.amc").error().message,
              HasSubstr("'foot' is not joined to the root"));
  EXPECT_THAT(read_asf_amc("", "empty.asf", "", "x.amc").error().text(),
              HasSubstr("empty.asf: has no bones"));
  EXPECT_THAT(read_asf_amc(fixture_text("leg.asf"), "leg.asf", "", "x.amc").error().text(),
              HasSubstr("x.amc: has no frames"));
}

TEST(AsfAmc, ReportsARootThatDoesNotBeginAtTheOrigin) {
  std::string asf = fixture_text("leg.asf");
  asf.replace(asf.find("position 0 0 0"), 14, "position 5 6 7");
  const auto motion = read_asf_amc(asf, "leg.asf", fixture_text("leg.amc"), "leg.amc");
  ASSERT_TRUE(motion);
  expect_the_leg(*motion);  // the motion's values replace it
  EXPECT_TRUE(test::has_warning(motion->warnings, "root-offset"));
}

TEST(AsfAmc, SurvivesEveryCutOfBothFiles) {
  const std::string asf = fixture_text("leg.asf"), amc = fixture_text("leg.amc");
  for (std::size_t length = 0; length < asf.size(); ++length) {
    const auto motion = read_asf_amc(std::string_view(asf).substr(0, length), "cut.asf", amc, "leg.amc");
    EXPECT_TRUE(motion || !motion.error().message.empty()) << length;
  }
  for (std::size_t length = 0; length < amc.size(); ++length) {
    const auto motion = read_asf_amc(asf, "leg.asf", std::string_view(amc).substr(0, length), "cut.amc");
    EXPECT_TRUE(motion ? motion->frames.size() >= 1 : !motion.error().message.empty()) << length;
  }
}

TEST(AsfAmc, SurvivesAnyDamage) {
  std::mt19937 random(12);
  const std::string asf = fixture_text("leg.asf"), amc = fixture_text("leg.amc");
  for (int i = 0; i < 3000; ++i) {
    const bool in_skeleton = i % 2 == 0;
    const auto motion = read_asf_amc(in_skeleton ? test::damaged(asf, random) : asf, "damaged.asf",
                                     in_skeleton ? amc : test::damaged(amc, random), "damaged.amc");
    EXPECT_TRUE(motion ? !motion->frames.empty() : !motion.error().message.empty());
  }
}

}  // namespace
}  // namespace abrazo::asf_amc_test
