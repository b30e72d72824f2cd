// Where a picture lies in its view, what is drawn over it, and how a video's time goes with the timeline's.
#include <gtest/gtest.h>

#include "core/motion/body/joint_set.hpp"
#include "widgets/video/picture_framing.hpp"
#include "widgets/video/video_overlay.hpp"
#include "widgets/video/video_words.hpp"

namespace abrazo::widgets::video_arithmetic_test {
namespace {

constexpr PictureSize picture{1280, 720};

TEST(PictureFraming, LetterboxesAWidePictureInAHighView) {
  const PictureFraming frame = framing(picture, {640, 640}, {});
  EXPECT_DOUBLE_EQ(frame.scale, 0.5);
  EXPECT_DOUBLE_EQ(frame.left, 0);
  EXPECT_DOUBLE_EQ(frame.top, (640 - 360) / 2.0);
}

TEST(PictureFraming, TheMiddleOfTheFirstPixelIsZero) {
  const PictureFraming frame = framing(picture, {2560, 1440}, {});
  EXPECT_DOUBLE_EQ(frame.x(0), 1) << "a pixel is two wide in the view";
  EXPECT_DOUBLE_EQ(frame.to_picture(1, 1).x(), 0);
  EXPECT_DOUBLE_EQ(frame.to_picture(0, 0).y(), -0.5);
}

TEST(PictureFraming, ZoomingHoldsWhatIsUnderThePointer) {
  const PictureSize view{640, 360};
  const Pixel before = framing(picture, view, {}).to_picture(200, 100);
  const PictureZoom near = zoomed(picture, view, {}, 4, 200, 100);
  EXPECT_NEAR((framing(picture, view, near).to_picture(200, 100) - before).norm(), 0, 1e-9);
  EXPECT_DOUBLE_EQ(framing(picture, view, near).scale, 2);
}

TEST(PictureFraming, NeverLeavesTheWholeNorTheNearestBehind) {
  const PictureSize view{640, 360};
  EXPECT_TRUE(zoomed(picture, view, {}, 0.1, 0, 0).is_fitted());
  EXPECT_DOUBLE_EQ(framing(picture, view, zoomed(picture, view, {}, 1e9, 10, 10)).scale,
                   PictureZoom::nearest);
}

TEST(PictureFraming, PanningStopsAtThePicturesEdge) {
  const PictureSize view{640, 360};
  PictureZoom near = zoomed(picture, view, {}, 2, 320, 180);
  near = panned(picture, view, near, 1e6, 0);
  EXPECT_DOUBLE_EQ(framing(picture, view, near).left, 0);
  near = panned(picture, view, near, -1e6, -1e6);
  EXPECT_DOUBLE_EQ(framing(picture, view, near).left, 640 - 1280);
  EXPECT_DOUBLE_EQ(framing(picture, view, near).top, 360 - 720);
}

TEST(PictureFraming, AViewWithoutPictureIsHarmless) {
  EXPECT_DOUBLE_EQ(framing({}, {640, 360}, {}).scale, 1);
  EXPECT_DOUBLE_EQ(framing(picture, {0, 0}, {}).scale, 1);
}

/// At the origin, looking along z; x to the right, y down.
CameraModel plain_camera() {
  CameraModel camera;
  camera.intrinsics = {200, 100, 100, 100, 100, 50, {}};
  return camera;
}

PairPose in_front() {
  PairPose pose;
  for (int i = 0; i < pair_vertex_count; ++i) pose.row(i) << 0.01 * i, -0.01 * i, 2;
  return pose;
}

TEST(VideoOverlay, HasEveryBoneOfBothBodiesAndTheMeshBehindThem) {
  const std::vector<MeshEdge> edges = {{0, 25}, {0, 1}, {0, 5}, {3, 40}};
  const VideoOverlay overlay = project_overlay(plain_camera(), in_front(), edges, {});
  ASSERT_EQ(overlay.lines.size(), 2u * bone_count + 2);
  EXPECT_EQ(overlay.lines[0].part, OverlayLine::Part::BetweenBodies);
  EXPECT_EQ(overlay.lines[1].part, OverlayLine::Part::BetweenBodies);
  EXPECT_EQ(overlay.lines.back().part, OverlayLine::Part::Active) << "drawn last";
}

TEST(VideoOverlay, EdgesWithinABodyAreShownWithoutTheBones) {
  const std::vector<MeshEdge> edges = {{0, 1}, {0, 5}};
  OverlayParts parts{false, false, true, true};
  const VideoOverlay overlay = project_overlay(plain_camera(), in_front(), edges, parts);
  ASSERT_EQ(overlay.lines.size(), 1u);
  EXPECT_EQ(overlay.lines[0].part, OverlayLine::Part::WithinBody);
}

TEST(VideoOverlay, JointsLieWhereThePinholeHasThem) {
  const VideoOverlay overlay = project_overlay(plain_camera(), in_front(), {}, {});
  ASSERT_TRUE(overlay.joints[30]);
  EXPECT_NEAR(overlay.joints[30]->x(), 100 + 100 * 0.3 / 2, 1e-9);
  EXPECT_NEAR(overlay.joints[30]->y(), 50 - 100 * 0.3 / 2, 1e-9);
}

TEST(VideoOverlay, WhatIsBehindTheCameraIsNotThere) {
  PairPose pose = in_front();
  pose.col(2).setConstant(-2);
  const VideoOverlay overlay = project_overlay(plain_camera(), pose, {}, {});
  EXPECT_TRUE(overlay.empty());
  EXPECT_FALSE(overlay.joints[0]);
}

TEST(VideoOverlay, APoseBetweenTwoFramesLiesOnTheStraightWay) {
  const PairPose a = PairPose::Zero(), b = PairPose::Constant(0.2);
  EXPECT_DOUBLE_EQ(between(a, b, 0.25)(7, 1), 0.05);
  EXPECT_DOUBLE_EQ(between(a, b, 3)(7, 1), 0.2) << "never beyond";
}

TEST(VideoOverlay, NothingIsBetweenTwoPosesWhenTheBodiesChangedTheirParts) {
  const PairPose a = PairPose::Zero(), b = PairPose::Constant(1);
  EXPECT_DOUBLE_EQ(between(a, b, 0.9)(7, 1), 0);
  EXPECT_DOUBLE_EQ(between(a, b, 1)(7, 1), 1);
}

TEST(VideoWords, TellTheOffsetFromTheTimelinesSide) {
  EXPECT_EQ(offset_text({}), "both begin together");
  EXPECT_EQ(offset_text({{{0, 1.25}}, 1}), "the video began 1.250 s earlier");
  EXPECT_EQ(offset_text({{{3, 1}}, 2}), "the video began 2.500 s later") << "in seconds of the timeline";
}

TEST(VideoWords, TellTheDriftInWhatItAmountsTo) {
  EXPECT_EQ(rate_text({}), "both at the same rate");
  EXPECT_EQ(rate_text({{{0, 0}, {100, 100.012}}, 1}), "rate 1.000120: the video gains 7.2 ms a minute");
  EXPECT_EQ(rate_text({{}, 0.5}), "rate 0.500000: the video loses 30.00 s a minute");
}

TEST(SyncPoints, TheFirstGivesTheOffsetTheSecondTheRate) {
  VideoSync sync = with_sync_point({}, {4, 5});
  EXPECT_DOUBLE_EQ(sync.video_time(10), 11);
  sync = with_sync_point(sync, {2, 1});
  ASSERT_EQ(sync.points.size(), 2u);
  EXPECT_DOUBLE_EQ(sync.points[0].subject_s, 2) << "in order";
  EXPECT_DOUBLE_EQ(sync.effective_rate(), 2);
}

TEST(SyncPoints, AThirdReplacesTheNearerAndTheSameTimeIsReplaced) {
  VideoSync sync{{{0, 0}, {10, 10}}, 1};
  sync = with_sync_point(sync, {9, 10});
  ASSERT_EQ(sync.points.size(), 2u);
  EXPECT_DOUBLE_EQ(sync.points[1].subject_s, 9);
  const VideoSync one = with_sync_point(with_sync_point({}, {3, 1}), {3, 2});
  ASSERT_EQ(one.points.size(), 1u);
  EXPECT_DOUBLE_EQ(one.points[0].video_s, 2);
}

TEST(SyncPoints, WithoutTheSecondTheRateIsOneAgain) {
  const VideoSync sync = without_sync_point({{{0, 0}, {10, 11}}, 1}, 1);
  ASSERT_EQ(sync.points.size(), 1u);
  EXPECT_DOUBLE_EQ(sync.effective_rate(), 1);
  EXPECT_EQ(without_sync_point(sync, 7), sync);
}

TEST(SyncPoints, ATypedOffsetKeepsTheRateAndATypedRateTheFirstPoint) {
  const VideoSync sync{{{2, 3}, {4, 7}}, 1};
  const VideoSync moved = with_offset(sync, 1);
  EXPECT_DOUBLE_EQ(moved.video_time(0), 1);
  EXPECT_DOUBLE_EQ(moved.effective_rate(), 2);
  const VideoSync slower = with_rate(sync, 0.5);
  EXPECT_DOUBLE_EQ(slower.video_time(2), 3);
  EXPECT_DOUBLE_EQ(slower.video_time(4), 4);
}

}  // namespace
}  // namespace abrazo::widgets::video_arithmetic_test
