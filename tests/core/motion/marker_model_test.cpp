#include "core/motion/joints/marker_model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "core/motion/files/import_clip.hpp"
#include "core/motion/joints/marker_gaps.hpp"
#include "core/motion/joints/marker_geometry.hpp"
#include "tests/core/motion/marker_body.hpp"
#include "tests/core/motion/motion_fixtures.hpp"

namespace abrazo::marker_model_test {
namespace {

using test::has_warning;
using test::the_warning;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const MarkerModel& model(const std::string& name) {
  for (const MarkerModel& each : builtin_marker_models())
    if (each.name == name) return each;
  throw std::invalid_argument(name);
}

void lose(NamedMotion& motion, const std::string& marker, std::size_t begin, std::size_t end) {
  const auto place = std::find(motion.points.begin(), motion.points.end(), marker) - motion.points.begin();
  for (std::size_t f = begin; f < end; ++f)
    motion.frames[f].row(place).setConstant(std::numeric_limits<double>::quiet_NaN());
}

TEST(MarkerGeometry, FindsTheHipByHarringtonsRegression) {
  // Harrington 2007, table 4, for a width of 240 and a depth of 160 mm: x = -48.3, y = -82.9, z = 86.5.
  const Vec3 hip = hip_centre(0.240, 0.160, 1);
  EXPECT_NEAR(hip.z(), -0.0483, 1e-9);
  EXPECT_NEAR(hip.y(), -0.0829, 1e-9);
  EXPECT_NEAR(hip.x(), 0.0865, 1e-9);
  EXPECT_EQ(hip_centre(0.240, 0.160, -1).x(), -hip.x());
}

TEST(MarkerGeometry, PutsARightAngleAtTheJoint) {
  const Vec3 above(0, 1, 0), marker(0.06, 0.55, 0.02);
  const Vec3 joint = chord_centre(above, marker, Vec3(-1, 0, 0.3), 0.055);
  EXPECT_NEAR((joint - marker).norm(), 0.055, 1e-12);
  EXPECT_NEAR((joint - marker).dot(joint - above), 0, 1e-12);
  EXPECT_LT(joint.x(), marker.x());
  EXPECT_EQ(chord_centre(above, above + Vec3(0.01, 0, 0), Vec3(-1, 0, 0), 0.055), above + Vec3(0.01, 0, 0))
      << "nearer than the joint is wide: left as it is";
}

TEST(MarkerModels, FindTheJointsOfABodyThatIsKnown) {
  using namespace joints;
  for (const double knee : {0.0, 0.6}) {
    const test::MarkedBody body = test::marked_body(40, knee);
    const auto found = joints_of_markers(model("plug-in-gait"), body.markers, 1.0);
    ASSERT_TRUE(found) << found.error().text();
    ASSERT_EQ(found->frames.size(), 40U);
    // Where the model's own estimates (widths of joints, the neck and the head) are exact for this body, and
    // where they are off by the difference to an average one.
    const std::vector<std::pair<int, double>> tolerances = {{Root, 1e-9},
                                                            {left_hip, 1e-9},
                                                            {right_hip, 1e-9},
                                                            {left_knee, 0.003},
                                                            {right_knee, 0.003},
                                                            {left_ankle, 0.004},
                                                            {right_ankle, 0.004},
                                                            {left_toe_base, 0.005},
                                                            {left_shoulder, 0.006},
                                                            {right_shoulder, 0.006},
                                                            {left_elbow, 0.008},
                                                            {right_elbow, 0.008},
                                                            {left_wrist, 1e-9},
                                                            {left_hand, 0.005},
                                                            {right_hand, 0.005},
                                                            {LowerNeck, 1e-9},
                                                            {Head, 1e-9}};
    for (std::size_t f = 0; f < 40; f += 13)
      for (const auto& [joint, tolerance] : tolerances)
        EXPECT_LT((found->frames[f].row(joint) - body.poses[f].row(joint)).norm(), tolerance)
            << joint_names[static_cast<std::size_t>(joint)] << " in frame " << f << ", knee " << knee;
  }
}

TEST(MarkerModels, AreChosenByTheirMarkersAndKeepTheUnit) {
  test::MarkedBody body = test::marked_body(20, 0.2);
  for (Positions& frame : body.markers.frames) frame *= 1000;
  body.markers.metres_per_unit.reset();
  const auto clip = import_clip(body.markers, {});
  ASSERT_TRUE(clip) << clip.error().text();
  EXPECT_EQ(clip->report.joint_map, "plug-in-gait");
  EXPECT_EQ(clip->report.metres_per_unit, 0.001);
  EXPECT_NEAR((clip->clip.poses[5].row(joints::left_knee) - body.poses[5].row(joints::left_knee)).norm(), 0,
              0.004);
}

TEST(MarkerModels, UseInnerMarkersWhereThereAreAny) {
  test::MarkedBody body = test::marked_body(3, 0.3);
  body.markers.points.push_back("LKNM");
  body.markers.parents.push_back(-1);
  for (std::size_t f = 0; f < 3; ++f) {
    Positions& frame = body.markers.frames[f];
    const auto outer = std::find(body.markers.points.begin(), body.markers.points.end(), "LKNE") -
                       body.markers.points.begin();
    frame.conservativeResize(frame.rows() + 1, 3);
    frame.row(frame.rows() - 1) = 2 * body.poses[f].row(joints::left_knee) - frame.row(outer);
  }
  const auto found = joints_of_markers(model("plug-in-gait"), body.markers, 1.0);
  ASSERT_TRUE(found);
  EXPECT_LT((found->frames[2].row(joints::left_knee) - body.poses[2].row(joints::left_knee)).norm(), 1e-12);
}

TEST(MarkerModels, KnowTheMarkersOfTheCmuLaboratoryAndOfOptiTrack) {
  EXPECT_THAT(missing_markers(model("cmu-markers"),
                              {"RFHD", "LFHD", "RBHD", "LBHD", "C7",   "T10",  "CLAV", "STRN", "RSHO",
                               "LSHO", "RELB", "LELB", "RWRA", "RWRB", "LWRA", "LWRB", "RFWT", "LFWT",
                               "RBWT", "LBWT", "RKNE", "LKNE", "RANK", "LANK", "RTOE", "LTOE"}),
              IsEmpty());
  EXPECT_THAT(missing_markers(
                  model("optitrack-baseline"),
                  {"WaistLFront",   "WaistRFront",  "WaistLBack", "WaistRBack", "BackTop",   "Chest",
                   "BackLeft",      "BackRight",    "HeadTop",    "HeadFront",  "HeadSide",  "LShoulderBack",
                   "LShoulderTop",  "LElbowOut",    "LUArmHigh",  "LWristOut",  "LWristIn",  "LHandOut",
                   "RShoulderBack", "RShoulderTop", "RElbowOut",  "RUArmHigh",  "RWristOut", "RWristIn",
                   "RHandOut",      "LKneeOut",     "LThigh",     "LAnkleOut",  "LShin",     "LToeOut",
                   "LToeIn",        "LToeTip",      "LHeel",      "RKneeOut",   "RThigh",    "RAnkleOut",
                   "RShin",         "RToeOut",      "RToeIn",     "RToeTip",    "RHeel"}),
              IsEmpty());
  EXPECT_THAT(missing_markers(model("plug-in-gait"), test::marked_body(1, 0).markers.points), IsEmpty());
  test::MarkedBody body = test::marked_body(1, 0);
  std::erase(body.markers.points, "LKNE");
  EXPECT_THAT(missing_markers(model("plug-in-gait"), body.markers.points), ElementsAre("LKNE"));
}

TEST(MarkerGaps, BridgesAShortGapByACurveAndSaysWhere) {
  NamedMotion motion;
  motion.points = {"A"}, motion.parents = {-1}, motion.fps = 100;
  for (int f = 0; f < 30; ++f) motion.frames.push_back(Positions(Eigen::RowVector3d(f * f, 0, 1)));
  lose(motion, "A", 10, 15);
  fill_gaps(motion);
  // A parabola; the one-sided speeds at both ends are half a step off, which moves the middle by 0.25 * 6
  // / 4.
  for (std::size_t f = 10; f < 15; ++f) EXPECT_NEAR(motion.frames[f](0, 0), static_cast<double>(f * f), 1.6);
  EXPECT_EQ(the_warning(motion.warnings, "gaps").detail,
            "1 gap of A (5 frames in all, the longest 5, A from frame 10) bridged by a curve");
}

TEST(MarkerGaps, CarriesAMarkerByItsSegmentThroughALongGap) {
  test::MarkedBody body = test::marked_body(200, 0.3);
  const NamedMotion whole = body.markers;
  lose(body.markers, "LASI", 40, 160);
  lose(body.markers, "C7", 0, 90);
  fill_gaps(body.markers);
  EXPECT_THAT(the_warning(body.markers.warnings, "gaps-carried").detail,
              HasSubstr("2 gaps of C7, LASI (210 frames"));
  for (const std::size_t f : {5U, 80U, 130U})
    EXPECT_LT((body.markers.frames[f] - whole.frames[f]).norm(), 1e-9);
}

TEST(MarkerGaps, LeavesALongGapThatNothingTellsOfAndTheJointIsRefused) {
  test::MarkedBody body = test::marked_body(200, 0.3);
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.05);  // no two markers keep their distance
  for (Positions& frame : body.markers.frames)
    frame = frame.unaryExpr([&](double v) { return v + noise(random); });
  lose(body.markers, "LKNE", 20, 150);
  fill_gaps(body.markers);
  EXPECT_TRUE(has_warning(body.markers.warnings, "gaps-left"));
  const auto clip = import_clip(body.markers, {});
  ASSERT_FALSE(clip);
  EXPECT_THAT(clip.error().text(), HasSubstr("LKNE is missing in frames 20 to 149"));
}

TEST(MarkerGaps, DoesWithoutAMarkerThatIsNotNeeded) {
  test::MarkedBody body = test::marked_body(200, 0.3);
  lose(body.markers, "LTHI", 0, 200);
  fill_gaps(body.markers);
  EXPECT_THAT(the_warning(body.markers.warnings, "never-seen").detail, HasSubstr("LTHI"));
  EXPECT_TRUE(import_clip(body.markers, {}));
}

}  // namespace
}  // namespace abrazo::marker_model_test
