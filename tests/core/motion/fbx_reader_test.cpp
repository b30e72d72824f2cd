#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "core/motion/scenes/assimp_scene.hpp"
#include "tests/core/motion/fbx_text.hpp"
#include "tests/core/motion/motion_fixtures.hpp"

namespace abrazo::fbx_reader_test {
namespace {

using test::fbx_property;
using test::fbx_text;
using test::FbxJoint;
using test::FbxSettings;
using test::has_warning;
using test::place;
using test::the_warning;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Result<std::vector<NamedMotion>> read(const std::string& text, const std::string& animation = {}) {
  return read_scene(text, MotionFormat::Fbx, "walk.fbx", animation);
}
NamedMotion read_one(const std::string& text, const std::string& animation = {}) {
  Result<std::vector<NamedMotion>> motions = read(text, animation);
  if (motions && motions->size() == 1) return std::move(motions->front());
  ADD_FAILURE() << (motions ? "not one performer" : motions.error().text());
  return {};
}

std::vector<std::pair<double, Vec3>> keys(double fps, int count, double degrees = 2) {
  std::vector<std::pair<double, Vec3>> list;
  for (int k = 0; k < count; ++k)
    list.emplace_back(k / fps, Vec3(degrees * k, 0.5 * degrees * k, -0.7 * degrees * k));
  return list;
}

/// Ten joints, all of which turn at 30 keys a second for one second.
std::vector<FbxJoint> chain() {
  std::vector<FbxJoint> joints;
  for (int j = 0; j < 10; ++j)
    joints.push_back({"J" + std::to_string(j), {1.0 * j, 10, 0.5 * j}, "", keys(30, 31)});
  return joints;
}

Eigen::Affine3d turned(const Vec3& degrees) {
  const Vec3 angles = degrees * std::numbers::pi / 180;
  return Eigen::Affine3d(Eigen::AngleAxisd(angles.z(), Vec3::UnitZ()) *
                         Eigen::AngleAxisd(angles.y(), Vec3::UnitY()) *
                         Eigen::AngleAxisd(angles.x(), Vec3::UnitX()));
}
Eigen::Affine3d moved(const Vec3& by) {
  return Eigen::Affine3d(Eigen::Translation3d(by));
}

TEST(ReadFbx, AJointWithAnOrientationOfItsOwnStandsWhereItsKeysPutIt) {
  std::vector<FbxJoint> joints = chain();
  const std::vector<Vec3> orientations = {{0, 0, 90}, {10, -20, 30}, {180, 5, 0}};
  for (std::size_t j = 0; j < 3; ++j) joints[2 * j].properties = fbx_property("PreRotation", orientations[j]);
  const NamedMotion motion = read_one(fbx_text(joints));
  ASSERT_EQ(motion.frames.size(), 31U);
  EXPECT_EQ(motion.fps, 30.0);
  for (const std::size_t frame : {0U, 12U, 30U}) {
    Eigen::Affine3d world = Eigen::Affine3d::Identity();
    for (std::size_t j = 0; j < joints.size(); ++j) {
      world = world * moved(joints[j].place);
      if (j % 2 == 0 && j < 6) world = world * turned(orientations[j / 2]);
      world = world * turned(joints[j].rotations[frame].second);
      test::expect_near(place(motion, frame, joints[j].name), world.translation(), 1e-4);
    }
  }
}

TEST(ReadFbx, AStillJointKeepsItsOrientation) {
  std::vector<FbxJoint> joints = chain();
  joints[4].rotations.clear();
  joints[4].properties = fbx_property("PreRotation", {0, 0, 90});
  const NamedMotion motion = read_one(fbx_text(joints));
  test::expect_near(place(motion, 0, "J5") - place(motion, 0, "J4"), {-10, 5, 2.5}, 1e-4);
}

TEST(ReadFbx, ATurnBehindTheKeysIsAppliedInverted) {
  std::vector<FbxJoint> joints = chain();
  const Vec3 before(10, -20, 30), behind(40, 15, -25), pivot(1, 2, 3);
  joints[2].properties = fbx_property("PostRotation", behind);
  joints[4].properties = fbx_property("PreRotation", before) + fbx_property("PostRotation", behind);
  joints[5].properties = fbx_property("PostRotation", behind) + fbx_property("RotationPivot", pivot);
  joints[6].properties = fbx_property("PostRotation", behind);
  joints[6].rotations.clear();  // it is still
  const NamedMotion motion = read_one(fbx_text(joints));
  for (const std::size_t frame : {0U, 17U}) {
    Eigen::Affine3d world = Eigen::Affine3d::Identity();
    for (std::size_t j = 0; j < joints.size(); ++j) {
      world = world * moved(joints[j].place);
      if (j == 4) world = world * turned(before);
      if (j == 5) world = world * moved(pivot);
      if (!joints[j].rotations.empty()) world = world * turned(joints[j].rotations[frame].second);
      if (j == 2 || (j >= 4 && j <= 6)) world = world * turned(behind).inverse();
      if (j == 5) world = world * moved(-pivot);
      test::expect_near(place(motion, frame, joints[j].name), world.translation(), 1e-4);
    }
  }
}

TEST(ReadFbx, AJointTurnsAboutItsPivot) {
  std::vector<FbxJoint> joints = chain();
  const Vec3 pivot(1, 2, 3), offset(0.5, 0, -1);
  joints[3].properties = fbx_property("RotationPivot", pivot) + fbx_property("RotationOffset", offset) +
                         fbx_property("PreRotation", {0, 30, 0});
  const NamedMotion motion = read_one(fbx_text(joints));
  Eigen::Affine3d world = Eigen::Affine3d::Identity();
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Eigen::Affine3d turn = turned(joints[j].rotations[20].second);
    world = world * moved(joints[j].place);
    world = j == 3 ? world * moved(offset) * moved(pivot) * turned({0, 30, 0}) * turn * moved(-pivot)
                   : world * turn;
    test::expect_near(place(motion, 20, joints[j].name), world.translation(), 1e-4);
  }
}

TEST(ReadFbx, TheRateIsThatOfMostJointsAndNotOfTheDensest) {
  std::vector<FbxJoint> joints = chain();
  joints[7].rotations = keys(300, 301, 0.2);
  const NamedMotion motion = read_one(fbx_text(joints));
  EXPECT_EQ(motion.fps, 30.0);
  EXPECT_EQ(motion.frames.size(), 31U);
  EXPECT_FALSE(has_warning(motion.warnings, "sampled"));
}

TEST(ReadFbx, KeysThatWereThinnedOutAreSampledAtTheFilesRate) {
  std::vector<FbxJoint> joints = chain();
  for (FbxJoint& joint : joints) joint.rotations = keys(10, 11);
  const NamedMotion motion = read_one(fbx_text(joints));
  EXPECT_EQ(motion.fps, 30.0);
  EXPECT_EQ(motion.frames.size(), 31U);
  EXPECT_THAT(the_warning(motion.warnings, "sampled").detail, HasSubstr("found 30 times a second"));
}

TEST(ReadFbx, KeysBetweenTheFramesOfTheFilesRateAreNotLost) {
  std::vector<FbxJoint> joints = chain();
  for (FbxJoint& joint : joints) joint.rotations = keys(120, 121, 0.5);
  EXPECT_EQ(read_one(fbx_text(joints, {.time_mode = 11})).fps, 120.0) << "24 frames a second are its film's";
}

TEST(ReadFbx, ReadsAnyAxesAndUnits) {
  const NamedMotion usual = read_one(fbx_text(chain()));
  EXPECT_EQ(usual.up_axis, UpAxis::Y);
  EXPECT_EQ(usual.metres_per_unit, 0.01);
  const NamedMotion z_up =
      read_one(fbx_text(chain(), {.up = 2, .front = 1, .front_sign = -1, .centimetres_per_unit = 2.54}));
  EXPECT_EQ(z_up.up_axis, UpAxis::Z);
  EXPECT_NEAR(*z_up.metres_per_unit, 0.0254, 1e-9);
  test::expect_near(place(z_up, 9, "J9"), place(usual, 9, "J9"), 1e-9);
  const NamedMotion x_up = read_one(fbx_text(chain(), {.up = 0, .front = 1, .coord = 2}));
  EXPECT_EQ(x_up.up_axis, UpAxis::Y);
  const Vec3 there = place(usual, 9, "J9");
  test::expect_near(place(x_up, 9, "J9"), {there.z(), there.x(), there.y()}, 1e-9);
}

TEST(ReadFbx, TakesTheAnimationThatIsAskedFor) {
  const std::string text = fbx_text(chain(), {.takes = {"dance", "Armature|rest|Layer0"}});
  const NamedMotion longest = read_one(text);
  EXPECT_EQ(longest.frames.size(), 31U);
  EXPECT_THAT(longest.animations, ElementsAre("dance", "Armature|rest|Layer0"));
  EXPECT_EQ(the_warning(longest.warnings, "animations").hint, Hint::ChooseAnimation);
  const NamedMotion rest = read_one(text, "rest");
  EXPECT_EQ(rest.frames.size(), 16U);
  EXPECT_THAT(rest.animations, ElementsAre("Armature|rest|Layer0", "dance"));
  EXPECT_FALSE(has_warning(rest.warnings, "animations")) << "it was asked for";
  EXPECT_THAT(read(text, "sleep").error().text(),
              HasSubstr("walk.fbx: has no animation 'sleep'; it holds dance, Armature|rest|Layer0"));
}

TEST(ReadFbx, SaysWhatIsWrongWithABrokenFile) {
  const std::string text = fbx_text(chain());
  EXPECT_THAT(read(text.substr(0, text.size() / 2)).error().text(), HasSubstr("cannot be read as FBX"));
  std::string still = text;
  for (auto at = still.find("Lcl Rotation\"\n"); at != std::string::npos; at = still.find("Lcl Rotation\"\n"))
    still.replace(at, 12, "Lcl Nothing");
  EXPECT_THAT(read(still).error().text(), HasSubstr("holds no animation"));
  std::string far = text;
  far.replace(far.find(",0,10,0\n"), 8, ",0,1e999,0\n");
  EXPECT_THAT(read(far).error().text(), HasSubstr("walk.fbx: "));
}

}  // namespace
}  // namespace abrazo::fbx_reader_test
