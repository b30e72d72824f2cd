// The camera of a video from joints that were pointed at: against a camera that is known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <random>

#include "core/choreography/salsa.hpp"
#include "core/video/camera_model.hpp"
#include "core/video/video_reader.hpp"
#include "core/video/video_writer.hpp"

namespace abrazo::test::camera_solver_test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

CameraPose looking(const Vec3& from, const Vec3& at) {
  const Vec3 ahead = (at - from).normalized(), right = ahead.cross(Vec3::UnitY()).normalized();
  CameraPose pose;
  pose.rotation << right.transpose(), ahead.cross(right).transpose(), ahead.transpose();
  pose.translation = -pose.rotation * from;
  return pose;
}

CameraModel true_camera() {
  CameraModel camera;
  camera.intrinsics = {1280, 720, 1050, 1050, 652, 351, {-0.21, 0.06, 0.0008, -0.0005, -0.004, 0, 0, 0}};
  camera.pose = looking({2.6, 1.7, 3.4}, {0.1, 0.9, 0.2});
  return camera;
}

/// Two dancers at four times, as an annotator picks them: six joints in each of four pictures.
struct Scene {
  std::vector<PairPose> frames;
  double fps = 30;
};

Scene dance() {
  ChoreographyOptions options;
  options.minutes = 0.15;
  options.take_seconds = 9;
  options.fps = 30;
  const PairedTake take = generate_salsa(options).front();
  Scene scene;
  const Vec3 middle = 0.5 * (take.a.poses[0].row(0) + take.b.poses[0].row(0)).transpose();
  for (std::size_t i = 0; i < take.a.poses.size() && i < 150; ++i) {
    PairPose pair;
    pair << take.a.poses[i], take.b.poses[i];
    pair.rowwise() -= Vec3(middle.x(), 0, middle.z()).transpose().eval();
    scene.frames.push_back(pair);
  }
  return scene;
}

std::vector<PickedPoint> picked(const Scene& scene, const CameraModel& camera, double noise_px,
                                unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 1);
  std::vector<PickedPoint> points;
  for (const std::size_t frame : {std::size_t{5}, std::size_t{45}, std::size_t{90}, std::size_t{140}})
    for (const int vertex : {4, 16, 20, 25 + 9, 25 + 16, 25 + 24}) {
      const Vec3 world = scene.frames[frame].row(vertex).transpose();
      const auto pixel = camera.project(world);
      if (!pixel) continue;
      PickedPoint point;
      point.world = world;
      point.pixel = *pixel + noise_px * Pixel(noise(random), noise(random));
      points.push_back(point);
    }
  return points;
}

double angle_deg(const CameraPose& a, const CameraPose& b) {
  return Eigen::AngleAxisd(a.rotation * b.rotation.transpose()).angle() * 180 / std::numbers::pi;
}

struct Reprojection {
  double rms_px = 0, worst_px = 0;
};

Reprojection compared(const Scene& scene, const CameraModel& solved, const CameraModel& truth) {
  Reprojection result;
  int count = 0;
  for (const PairPose& pair : scene.frames)
    for (int vertex = 0; vertex < pair_vertex_count; ++vertex) {
      const auto ours = solved.project(pair.row(vertex).transpose()),
                 theirs = truth.project(pair.row(vertex).transpose());
      if (!ours || !theirs) continue;
      const double off = (*ours - *theirs).norm();
      result.rms_px += off * off;
      result.worst_px = std::max(result.worst_px, off);
      ++count;
    }
  result.rms_px = std::sqrt(result.rms_px / count);
  return result;
}

TEST(SolveCamera, FindsItExactlyFromExactPoints) {
  const Scene scene = dance();
  const CameraModel truth = true_camera();
  const auto solved = solve_camera(truth.intrinsics, picked(scene, truth, 0, 1), false);
  ASSERT_TRUE(solved) << solved.error().text();
  EXPECT_LT(solved->rms_px, 1e-4);
  EXPECT_LT((solved->camera.pose.position() - truth.pose.position()).norm(), 1e-4);
  EXPECT_LT(angle_deg(solved->camera.pose, truth.pose), 1e-3);
  EXPECT_THAT(solved->warnings, testing::IsEmpty());
}

TEST(SolveCamera, LeavesOutWhatWasPickedWrongly) {
  const Scene scene = dance();
  const CameraModel truth = true_camera();
  auto points = picked(scene, truth, 1, 2);
  for (const std::size_t wrong : {1u, 7u, 13u, 20u}) points[wrong].pixel += Pixel(60, wrong % 2 ? 45 : -80);
  const auto solved = solve_camera(truth.intrinsics, points, false);
  ASSERT_TRUE(solved) << solved.error().text();
  for (const std::size_t wrong : {1u, 7u, 13u, 20u}) EXPECT_FALSE(solved->used[wrong]);
  EXPECT_EQ(std::ranges::count(solved->used, false), 4);
  EXPECT_GT(solved->errors_px[1], 30);
  EXPECT_LT((solved->camera.pose.position() - truth.pose.position()).norm(), 0.1);
  EXPECT_THAT(solved->warnings, Contains(HasSubstr("4 of 24 points do not fit")));
}

TEST(SolveCamera, FindsTheFocalLengthToo) {
  const Scene scene = dance();
  CameraModel truth = true_camera();
  truth.intrinsics = guessed_intrinsics(1280, 720, 47);
  const auto solved = solve_camera(guessed_intrinsics(1280, 720, 70), picked(scene, truth, 1, 3), true);
  ASSERT_TRUE(solved) << solved.error().text();
  EXPECT_NEAR(solved->camera.intrinsics.fx / truth.intrinsics.fx, 1, 0.03);
  EXPECT_LT((solved->camera.pose.position() - truth.pose.position()).norm(), 0.15);
  EXPECT_LT(compared(scene, solved->camera, truth).worst_px, 4);
}

TEST(SolveCamera, GivesTheSameAnswerEachTime) {
  const Scene scene = dance();
  const auto points = picked(scene, true_camera(), 1, 4);
  const auto first = solve_camera(true_camera().intrinsics, points, false);
  const auto second = solve_camera(true_camera().intrinsics, points, false);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->camera, second->camera);
}

TEST(SolveCamera, SaysWhatIsMissingOrCannotBe) {
  const Scene scene = dance();
  auto points = picked(scene, true_camera(), 0, 1);
  points.resize(5);
  EXPECT_THAT(solve_camera(true_camera().intrinsics, points, false).error().text(),
              HasSubstr("at least 6 picked points; there are 5"));
  points = picked(scene, true_camera(), 0, 1);
  points.resize(7);
  EXPECT_THAT(solve_camera(true_camera().intrinsics, points, true).error().text(),
              HasSubstr("at least 8 picked points to find the focal length too; there are 7"));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(0, 700);
  points = picked(scene, true_camera(), 0, 1);
  for (PickedPoint& point : points) point.pixel = {anywhere(random), anywhere(random)};
  EXPECT_FALSE(solve_camera(true_camera().intrinsics, points, false));
}

TEST(SolveCamera, WarnsOfPointsInAPlaneAndInACorner) {
  const CameraModel truth = true_camera();
  std::vector<PickedPoint> flat, near;
  for (int i = 0; i < 12; ++i) {
    PickedPoint point;
    point.world = {0.4 * (i % 4), 0.3 * (i / 4), 0};
    point.pixel = *truth.project(point.world);
    flat.push_back(point);
    point.world = {0.02 * (i % 4), 0.9 + 0.015 * (i / 4), 0.015 * (i % 3)};
    point.pixel = *truth.project(point.world);
    near.push_back(point);
  }
  const auto in_plane = solve_camera(truth.intrinsics, flat, false);
  ASSERT_TRUE(in_plane) << in_plane.error().text();
  EXPECT_THAT(in_plane->warnings, Contains(HasSubstr("nearly in a plane")));
  const auto in_corner = solve_camera(truth.intrinsics, near, false);
  ASSERT_TRUE(in_corner) << in_corner.error().text();
  EXPECT_THAT(in_corner->warnings, Contains(HasSubstr("all in one part of the picture")));
  EXPECT_THAT(in_corner->warnings, Contains(HasSubstr("uncertain by about")));
}

// ---- the whole way: a video of a known camera, joints pointed at in it, and the overlay over every picture

constexpr int disc_px = 5;

cv::Mat drawn(const PairPose& pair, const CameraModel& camera, int marked) {
  cv::Mat rgb(720, 1280, CV_8UC3, cv::Scalar(40, 44, 52));
  constexpr int shift = 4;  // discs to a sixteenth of a pixel
  for (int vertex = 0; vertex < pair_vertex_count; ++vertex) {
    if (vertex == marked) continue;
    if (const auto at = camera.project(pair.row(vertex).transpose()))
      cv::circle(rgb, cv::Point(cvRound(at->x() * 16), cvRound(at->y() * 16)), 16 * disc_px,
                 cv::Scalar(90, 90, 200), cv::FILLED, cv::LINE_AA, shift);
  }
  if (const auto at = camera.project(pair.row(marked).transpose()))
    cv::circle(rgb, cv::Point(cvRound(at->x() * 16), cvRound(at->y() * 16)), 16 * disc_px,
               cv::Scalar(255, 255, 255), cv::FILLED, cv::LINE_AA, shift);
  return rgb;
}

/// Middle of what is bright in the picture.
Pixel bright_middle(const VideoFrame& frame) {
  double sum = 0;
  Pixel middle(0, 0);
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      const std::size_t at = (static_cast<std::size_t>(y) * frame.width + x) * 3;
      const double weight = std::max(0, std::min(frame.rgb[at], frame.rgb[at + 1]) - 150);
      sum += weight;
      middle += weight * Pixel(x, y);
    }
  return middle / sum;
}

TEST(CalibratedOverlay, LiesOverTheBodiesOfASyntheticVideo) {
  const Scene scene = dance();
  const CameraModel truth = true_camera();
  const auto file =
      std::filesystem::path(testing::TempDir()) / ("overlay" + std::to_string(::getpid()) + ".mp4");
  const auto marked = [](std::size_t frame) { return static_cast<int>(frame * 7 % pair_vertex_count); };
  auto writer = VideoWriter::open(file, 1280, 720, scene.fps);
  ASSERT_TRUE(writer);
  for (std::size_t i = 0; i < scene.frames.size(); ++i) {
    const cv::Mat rgb = drawn(scene.frames[i], truth, marked(i));
    ASSERT_TRUE(writer->add({rgb.data, rgb.total() * 3}, rgb.step));
  }
  ASSERT_TRUE(writer->finish());

  Reprojection worst;
  double place_mm = 0, turned_deg = 0;
  CameraModel solution;
  for (unsigned seed = 10; seed < 20; ++seed) {
    const auto solved = solve_camera(truth.intrinsics, picked(scene, truth, 1, seed), false);
    ASSERT_TRUE(solved) << solved.error().text();
    const Reprojection off = compared(scene, solved->camera, truth);
    worst = {std::max(worst.rms_px, off.rms_px), std::max(worst.worst_px, off.worst_px)};
    place_mm = std::max(place_mm, 1000 * (solved->camera.pose.position() - truth.pose.position()).norm());
    turned_deg = std::max(turned_deg, angle_deg(solved->camera.pose, truth.pose));
    solution = solved->camera;
  }
  RecordProperty("worst_rms_px", std::to_string(worst.rms_px));
  RecordProperty("worst_px", std::to_string(worst.worst_px));
  RecordProperty("place_mm", std::to_string(place_mm));
  RecordProperty("turned_deg", std::to_string(turned_deg));
  std::printf(
      "24 picks, 1 px noise, 10 trials: all joints and frames rms <= %.2f px, at most %.2f px; camera %.1f "
      "mm, %.3f deg\n",
      worst.rms_px, worst.worst_px, place_mm, turned_deg);
  EXPECT_LT(worst.rms_px, 1.5);
  EXPECT_LT(worst.worst_px, 4);
  EXPECT_LT(place_mm, 60);
  EXPECT_LT(turned_deg, 0.8);

  auto reader = VideoReader::open(file, {});
  ASSERT_TRUE(reader) << reader.error().text();
  ASSERT_EQ(reader->facts().frames(), static_cast<int>(scene.frames.size()));
  double seen_px = 0;
  for (const int index : {149, 0, 75, 20, 110, 33}) {
    const auto frame = reader->frame(index);
    ASSERT_TRUE(frame);
    const PairPose& pair = scene.frames[static_cast<std::size_t>(index)];
    const auto over = solution.project(pair.row(marked(static_cast<std::size_t>(index))).transpose());
    ASSERT_TRUE(over);
    seen_px = std::max(seen_px, (*over - bright_middle(**frame)).norm());
  }
  std::printf("overlay against the decoded pictures: at most %.2f px\n", seen_px);
  EXPECT_LT(seen_px, 4);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace abrazo::test::camera_solver_test
