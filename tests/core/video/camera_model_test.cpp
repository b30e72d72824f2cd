// Where a camera sees points and bones: against hand values and against OpenCV's own projection.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <random>

#include "core/video/camera_model.hpp"
#include "core/video/lens.hpp"

namespace abrazo::test::camera_model_test {
namespace {

using ::testing::HasSubstr;

/// 3 m before the origin at a height of 1 m, looking along -Z: x right, y down, z ahead.
CameraPose from_the_front() {
  CameraPose pose;
  pose.rotation = Vec3(1, -1, -1).asDiagonal();
  pose.translation = Vec3(0, 1, 3);
  return pose;
}

CameraModel plain() {
  return {{640, 480, 500, 500, 320, 240, {}}, from_the_front()};
}

CameraModel barrel() {
  CameraModel camera = plain();
  camera.intrinsics.distortion = {-0.28, 0.09, 0.001, -0.0007, -0.012, 0, 0, 0};
  return camera;
}

TEST(CameraModel, StandsWhereItsPoseSays) {
  EXPECT_TRUE(from_the_front().position().isApprox(Vec3(0, 1, 3)));
}

TEST(CameraModel, ProjectsHandValues) {
  // 1 m to the right and 0.5 m up at a distance of 3 m: 500 / 3 pixels for each metre.
  const auto pixel = plain().project({1, 1.5, 0});
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x(), 320 + 500.0 / 3, 1e-9);
  EXPECT_NEAR(pixel->y(), 240 - 250.0 / 3, 1e-9);
}

TEST(CameraModel, DistortsByHandValues) {
  CameraModel camera = plain();
  camera.intrinsics.distortion = {0.1, 0, 0.01, 0.02, 0, 0, 0, 0};
  // x = y = 0.5, r^2 = 0.5: x (1 + 0.05) + 2 p1 x y + p2 (r^2 + 2 x^2) = 0.525 + 0.005 + 0.02
  const auto pixel = camera.project({1.5, -0.5, 0});
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x(), 320 + 500 * 0.55, 1e-9);
  EXPECT_NEAR(pixel->y(), 240 + 500 * (0.525 + 0.01 * (0.5 + 0.5) + 2 * 0.02 * 0.25), 1e-9);
}

TEST(CameraModel, AgreesWithOpenCv) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> wide(-1, 1);
  for (int trial = 0; trial < 200; ++trial) {
    CameraModel camera;
    camera.intrinsics = {
        1280,
        720,
        900 + 200 * wide(random),
        900 + 200 * wide(random),
        640,
        360,
        {0.2 * wide(random), 0.05 * wide(random), 0.002 * wide(random), 0.002 * wide(random),
         0.01 * wide(random), 0.02 * wide(random), 0.01 * wide(random), 0.005 * wide(random)}};
    const Vec3 axis = Vec3(wide(random), wide(random), wide(random)).normalized();
    const double angle = 3 * wide(random);
    camera.pose.rotation = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    camera.pose.translation = Vec3(wide(random), wide(random), 4 + wide(random));
    const Vec3 world(0.8 * wide(random), 0.8 * wide(random), 0.8 * wide(random));
    const cv::Matx33d matrix(camera.intrinsics.fx, 0, 640, 0, camera.intrinsics.fy, 360, 0, 0, 1);
    const std::vector<double> distortion(camera.intrinsics.distortion.begin(),
                                         camera.intrinsics.distortion.end());
    std::vector<cv::Point2d> theirs;
    const Vec3 turn = angle * axis, shift = camera.pose.translation;
    cv::projectPoints(std::vector<cv::Point3d>{{world.x(), world.y(), world.z()}},
                      cv::Vec3d(turn.x(), turn.y(), turn.z()), cv::Vec3d(shift.x(), shift.y(), shift.z()),
                      matrix, distortion, theirs);
    const auto ours = camera.project(world);
    ASSERT_TRUE(ours);
    EXPECT_NEAR(ours->x(), theirs[0].x, 1e-8);
    EXPECT_NEAR(ours->y(), theirs[0].y, 1e-8);
  }
}

TEST(CameraModel, DoesNotSeeWhatIsBehindIt) {
  EXPECT_FALSE(plain().project({0, 1, 3.5}));
  EXPECT_FALSE(plain().project({0, 1, 3}));
}

TEST(CameraModel, DoesNotSeeWhereTheDistortionFoldsBack) {
  CameraModel camera = plain();
  camera.intrinsics.distortion = {-0.3, 0, 0, 0, 0, 0, 0, 0};
  // r (1 - 0.3 r^2) grows up to r = 1 / sqrt(0.9) = 1.054 only.
  EXPECT_TRUE(camera.project({3, 1, 0})) << "r = 1";
  EXPECT_FALSE(camera.project({3.3, 1, 0})) << "r = 1.1";
}

TEST(CameraModel, StraightBonesStayStraightWithoutDistortion) {
  const auto pieces = plain().project_segment({-1, 0, 0}, {1, 2, 1});
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].size(), 2u);
}

double distance_px(const Pixel& point, const Pixel& a, const Pixel& b) {
  const Pixel along = b - a;
  const double t = std::clamp((point - a).dot(along) / std::max(along.squaredNorm(), 1e-12), 0.0, 1.0);
  return (point - a - t * along).norm();
}

TEST(CameraModel, ADistortedBoneIsFollowedToHalfAPixel) {
  const CameraModel camera = barrel();
  std::mt19937 random(9);
  std::uniform_real_distribution<double> wide(-1.4, 1.4);
  for (int bone = 0; bone < 50; ++bone) {
    const Vec3 from(wide(random), 1 + 0.7 * wide(random), 0.5 * wide(random));
    const Vec3 to(wide(random), 1 + 0.7 * wide(random), 0.5 * wide(random));
    const auto pieces = camera.project_segment(from, to);
    ASSERT_EQ(pieces.size(), 1u);
    for (double t = 0; t <= 1; t += 0.002) {
      const auto true_pixel = camera.project(from + t * (to - from));
      ASSERT_TRUE(true_pixel);
      double nearest = 1e9;
      for (std::size_t i = 1; i < pieces[0].size(); ++i)
        nearest = std::min(nearest, distance_px(*true_pixel, pieces[0][i - 1], pieces[0][i]));
      EXPECT_LE(nearest, 0.5);
    }
    EXPECT_LE(pieces[0].size(), 80u) << "no more pieces than it takes";
  }
}

TEST(CameraModel, ABoneThatGoesBehindTheCameraIsCutThere) {
  const auto pieces = plain().project_segment({0.2, 1, 0}, {0.2, 1, 5});
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_NEAR(pieces[0].front().x(), 320 + 500 * 0.2 / 3, 1e-9);
  EXPECT_GT(pieces[0].back().x(), 5000) << "towards the edge of the view";
  EXPECT_TRUE(plain().project_segment({0, 1, 4}, {0, 1, 5}).empty());
}

TEST(Intrinsics, AreScaledToPicturesOfTheSameShape) {
  const CameraIntrinsics half = *scaled({1280, 720, 900, 910, 639.5, 359.5, {0.1}}, 640, 360);
  EXPECT_DOUBLE_EQ(half.fx, 450);
  EXPECT_DOUBLE_EQ(half.fy, 455);
  EXPECT_DOUBLE_EQ(half.cx, 319.5) << "the middle stays the middle";
  EXPECT_DOUBLE_EQ(half.cy, 179.5);
  EXPECT_EQ(half.distortion[0], 0.1);
  const auto refused = scaled({1280, 720, 900, 900, 640, 360, {}}, 640, 480);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text(), HasSubstr("for 1280 x 720, the video is 640 x 480"));
}

TEST(Intrinsics, AreGuessedFromAFieldOfView) {
  const CameraIntrinsics guess = guessed_intrinsics(1280, 720, 90);
  EXPECT_NEAR(guess.fx, 640, 1e-9);
  EXPECT_EQ(guess.fx, guess.fy);
  EXPECT_DOUBLE_EQ(guess.cx, 639.5);
}

}  // namespace
}  // namespace abrazo::test::camera_model_test
