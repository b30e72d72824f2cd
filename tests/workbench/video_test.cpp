// The reference video in the whole window, on a video that was drawn from a known camera.
#include <QApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QSplitter>
#include <QThread>

#include "app/workbench/document/open_video.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "app/workbench/video/camera_desk.hpp"
#include "app/workbench/video/video_desk.hpp"
#include "core/motion/body/joint_set.hpp"
#include "tests/workbench/calibrated_video.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/video/camera_section.hpp"
#include "widgets/video/step_bar.hpp"
#include "widgets/video/sync_section.hpp"
#include "widgets/video/video_panel.hpp"
#include "widgets/video/video_view.hpp"

namespace abrazo::app::video_test {
namespace {

constexpr double filmed_from_s = 0.5;  // of the session
constexpr int pictures = 50;
constexpr double fps = 25;

class Video : public DemoWindow {
 protected:
  static void SetUpTestSuite() {
    showDemo({1400, 900}, 200);
    ticker().pause();
    s_camera = looking_camera(640, 360, 520, {2.6, 1.5, 3.0}, {0, 0.9, 0}, -0.1);
    s_file = home().filePath("dance.mp4");
    const CalibratedVideo video{s_camera, [](double at_s) { return desk().momentAt(at_s)->pose; },
                                filmed_from_s, pictures, fps};
    const Status written = write_calibrated_video(video, s_file);
    ASSERT_TRUE(written) << written.error().text();
  }
  void SetUp() override {
    DemoWindow::SetUp();
    desk().setVideos({}, {});
    desk().setLinked(true);
    ticker().seek(1);
    turn();
  }
  void TearDown() override { desk().setVideos({}, {}); }

  static VideoDesk& desk() { return *window().findChild<VideoDesk*>(); }
  static CameraDesk& camera() { return *window().findChild<CameraDesk*>(); }
  static widgets::VideoPanel& panel() { return desk().panel(); }
  static QString message() { return window().messages().text(); }
  static bool shows(int number) {
    return until([number] { return desk().shownPicture() && number_in(*desk().shownPicture()) == number; });
  }
  static void open() {
    window().openFiles({s_file});
    ASSERT_TRUE(until([] { return desk().shownPicture() != nullptr; }))
        << panel().view().notice().toStdString();
  }
  /// So that the video shows what it was drawn of.
  static void openInTime() {
    open();
    desk().changeCurrent([](VideoState& state) { state.sync.points = {{filmed_from_s, 0}}; }, "in time");
    ASSERT_TRUE(shows(static_cast<int>((1 - filmed_from_s) * fps)));
  }
  /// Exactly where the camera sees the joint.
  static void pick(int vertex) {
    camera().setJoint(vertex);
    const Vec3 at = desk().momentAt(desk().shownTime())->pose.row(vertex).transpose();
    emit panel().view().picked(seen_by(s_camera, at));
    turn();
  }
  /// With the mouse, as a person does it: a pixel of the screen is as near as it comes.
  static void click(int vertex) {
    camera().setJoint(vertex);
    const Vec3 at = desk().momentAt(desk().shownTime())->pose.row(vertex).transpose();
    const Pixel pixel = seen_by(s_camera, at);
    const auto frame = panel().view().framing();
    QTest::mouseClick(&panel().view(), Qt::LeftButton, {},
                      QPointF(frame.x(pixel.x()), frame.y(pixel.y())).toPoint());
    turn();
  }
  static const VideoState& state() { return *desk().current(); }

  static inline CameraModel s_camera;
  static inline QString s_file;
};

/// In a low column they were beside the picture, and cut.
TEST_F(Video, TheSectionsAreBesideThePictureOnlyWhereBothHaveRoom) {
  widgets::VideoPanel wide;
  const auto beside = [&wide](int width, int height) {
    wide.resize(width, height);
    turn();
    return wide.findChild<QSplitter*>()->orientation() == Qt::Horizontal;
  };
  wide.show();
  EXPECT_FALSE(beside(332, 200));
  EXPECT_FALSE(beside(700, 600)) << "it is high enough";
  EXPECT_TRUE(beside(700, 300));
}

TEST_F(Video, OpensBesideTheSessionAndShowsItsPanel) {
  open();
  EXPECT_TRUE(window().panels().isWanted("video"));
  EXPECT_TRUE(until([] { return panel().facts().contains("640 × 360"); })) << panel().facts().toStdString();
  EXPECT_TRUE(window().session()) << "what was open goes on";
}

/// A busy window hears of the file when its first picture is there already.
TEST_F(Video, SaysWhatTheFileIsThoughItsFirstPictureCameAtTheSameTime) {
  window().openFiles({s_file});
  while (!desk().currentVideo()->newest()) {  // no event is handled meanwhile
    QThread::msleep(1);
    desk().setLinked(true);  // asks for the picture of the cursor
  }
  turn();
  EXPECT_TRUE(panel().facts().contains("640 × 360")) << panel().facts().toStdString();
}

TEST_F(Video, ShowsThePictureOfTheCursorsTime) {
  openInTime();
  for (const double at_s : {0.5, 0.539, 0.541, 1.7, 0.9, 2.459}) {
    ticker().seek(at_s);
    EXPECT_TRUE(shows(static_cast<int>(std::floor((at_s - filmed_from_s) * fps + 1e-6)))) << at_s;
  }
}

TEST_F(Video, SaysThatItHasNoPictureOfATimeBeforeItBegan) {
  openInTime();
  ticker().seek(0.1);
  EXPECT_TRUE(until([] { return panel().view().notice().contains("begins 0.40 s later"); }))
      << panel().view().notice().toStdString();
  ticker().seek(1);
  EXPECT_TRUE(until([] { return panel().view().notice().isEmpty(); }));
}

TEST_F(Video, AStepGoesToTheNextPictureAndTheCursorToItsVeryTime) {
  openInTime();
  ticker().seek(1.013);
  ASSERT_TRUE(shows(12));
  emit panel().steps().stepRequested(1);
  ASSERT_TRUE(shows(13));
  EXPECT_NEAR(ticker().playback().cursor_s, filmed_from_s + 13 / fps, 1e-9);
  emit panel().steps().stepRequested(-1);
  ASSERT_TRUE(shows(12));
  EXPECT_NEAR(ticker().playback().cursor_s, filmed_from_s + 12 / fps, 1e-9);
}

TEST_F(Video, CommaAndPeriodStepItWhileItHasTheFocus) {
  openInTime();
  panel().view().setFocus();
  QTest::keyClick(&panel().view(), Qt::Key_Period);
  EXPECT_TRUE(shows(13));
  QTest::keyClick(&panel().view(), Qt::Key_Comma);
  EXPECT_TRUE(shows(12));
}

TEST_F(Video, ByItselfItIsSteppedWhileTheCursorStays) {
  openInTime();
  emit panel().steps().linkRequested(false);
  for (int i = 0; i < 5; ++i) desk().step(1);
  EXPECT_TRUE(shows(12 + 5));
  EXPECT_DOUBLE_EQ(ticker().playback().cursor_s, 1);
}

TEST_F(Video, OnePointGivesTheOffset) {
  open();
  desk().setLinked(false);
  while (desk().currentVideo()->requested() > 12) desk().step(-1);
  ASSERT_TRUE(shows(12));
  emit panel().sync().pointRequested();
  EXPECT_NEAR(state().sync.video_time(0), 12 / fps - 1, 1e-9);
  desk().setLinked(true);
  ticker().seek(1.6);
  EXPECT_TRUE(shows(27));
  EXPECT_TRUE(panel().sync().text().contains("later")) << panel().sync().text().toStdString();
}

TEST_F(Video, ASecondPointGivesTheRateAndItCanBeUndone) {
  openInTime();
  desk().setLinked(false);
  ticker().seek(1.5);
  turn();
  while (desk().currentVideo()->requested() < 30) desk().step(1);
  ASSERT_TRUE(shows(30));
  desk().setSyncPoint();
  EXPECT_NEAR(state().sync.effective_rate(), 30 / fps, 1e-9);
  window().undoStack().undo();
  EXPECT_EQ(state().sync.points.size(), 1u);
  window().undoStack().redo();
  EXPECT_EQ(state().sync.points.size(), 2u);
}

TEST_F(Video, RefusesPointsThatWouldLetTimeGoBackwards) {
  openInTime();
  desk().setLinked(false);
  ticker().seek(2);
  turn();
  while (desk().currentVideo()->requested() > 0) desk().step(-1);
  ASSERT_TRUE(shows(0));
  desk().setSyncPoint();
  EXPECT_EQ(state().sync.points.size(), 1u);
  EXPECT_TRUE(message().contains("choose two different instants")) << message().toStdString();
}

TEST_F(Video, OffsetAndRateCanBeTypedAndCleared) {
  open();
  emit panel().sync().offsetEntered(-0.5);
  EXPECT_NEAR(state().sync.video_time(0), -0.5, 1e-12);
  emit panel().sync().rateEntered(0.5);
  EXPECT_NEAR(state().sync.effective_rate(), 0.5, 1e-12);
  EXPECT_NEAR(state().sync.video_time(0), -0.5, 1e-12);
  emit panel().sync().clearRequested();
  EXPECT_EQ(state().sync, VideoSync{});
}

TEST_F(Video, SixPickedJointsGiveTheCameraAndTheOverlayLiesOnTheBodies) {
  openInTime();
  camera().loadIntrinsics(home().filePath("none.yml"));
  EXPECT_TRUE(message().contains("none.yml")) << "what is wrong with it is told";
  const QString lens = home().filePath("lens.yml");
  ASSERT_TRUE(write_intrinsics(s_camera.intrinsics, lens.toStdString()));
  camera().loadIntrinsics(lens);
  ASSERT_TRUE(state().intrinsics);
  for (const int joint : {joints::Head, joints::LeftFoot, joints::RightHand, joints::RightFoot}) pick(joint);
  EXPECT_FALSE(state().camera);
  EXPECT_TRUE(panel().camera().text().contains("2 more")) << panel().camera().text().toStdString();
  for (const int joint : {joints::Head, joints::LeftFoot, joints::RightFoot, joints::LeftHand})
    pick(joint_count + joint);
  ASSERT_TRUE(state().camera);
  ASSERT_TRUE(camera().solved());
  EXPECT_LT(camera().solved()->rms_px, 0.01);
  EXPECT_TRUE(panel().camera().text().contains("Reprojection error"))
      << panel().camera().text().toStdString();
  EXPECT_LT((state().camera->pose.position() - s_camera.pose.position()).norm(), 0.005);
  const auto& joints = panel().view().overlay().joints;
  const PairPose pose = desk().momentAt(desk().shownTime())->pose;
  for (int vertex = 0; vertex < pair_vertex_count; ++vertex) {
    ASSERT_TRUE(joints[static_cast<std::size_t>(vertex)]);
    EXPECT_LT(
        (*joints[static_cast<std::size_t>(vertex)] - seen_by(s_camera, pose.row(vertex).transpose())).norm(),
        5);
  }
}

TEST_F(Video, ArrowKeysMoveAPickByATenthOfAPixelAndThatIsOneStepOfUndo) {
  openInTime();
  click(joints::Head);
  ASSERT_EQ(state().picked.size(), 1u);
  const Pixel before = state().picked.front().pixel;
  for (int i = 0; i < 3; ++i) QTest::keyClick(&panel().view(), Qt::Key_Right);
  QTest::keyClick(&panel().view(), Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_NEAR(state().picked.front().pixel.x(), before.x() + 0.3, 1e-9);
  EXPECT_NEAR(state().picked.front().pixel.y(), before.y() - 1, 1e-9);
  EXPECT_DOUBLE_EQ(ticker().playback().cursor_s, 1) << "the cursor keeps out of it";
  window().undoStack().undo();
  EXPECT_EQ(state().picked.front().pixel, before);
  window().undoStack().undo();
  EXPECT_TRUE(state().picked.empty());
}

TEST_F(Video, APickIsDraggedToWhereTheButtonIsLetGoAndThatIsOneStepOfUndo) {
  openInTime();
  click(joints::Head);
  ASSERT_EQ(state().picked.size(), 1u);
  const Pixel before = state().picked.front().pixel;
  auto& view = panel().view();
  const auto frame = view.framing();
  const QPoint from = QPointF(frame.x(before.x()), frame.y(before.y())).toPoint(), to = from + QPoint(18, 9);
  QTest::mousePress(&view, Qt::LeftButton, {}, from);
  for (const QPoint& place : {(from + to) / 2, to}) {
    QMouseEvent move(QEvent::MouseMove, place, view.mapToGlobal(place), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&view, &move);
  }
  QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
  ASSERT_EQ(state().picked.size(), 1u) << "the next joint was not picked there";
  EXPECT_LT((state().picked.front().pixel - frame.to_picture(to.x(), to.y())).norm(), 1e-9);
  window().undoStack().undo();
  EXPECT_EQ(state().picked.front().pixel, before);
}

TEST_F(Video, AWrongPickIsMarkedAndDelTakesItAway) {
  openInTime();
  const QString lens = home().filePath("lens.yml");
  ASSERT_TRUE(write_intrinsics(s_camera.intrinsics, lens.toStdString()));
  camera().loadIntrinsics(lens);
  for (const int body : {0, joint_count})
    for (const int joint :
         {joints::Head, joints::LeftFoot, joints::RightFoot, joints::LeftHand, joints::RightHand})
      pick(body + joint);
  camera().movePick(3, state().picked[3].pixel + Pixel(60, -40), 900);
  turn();
  ASSERT_TRUE(camera().solved());
  EXPECT_FALSE(camera().solved()->used[3]);
  EXPECT_TRUE(panel().view().picks()[3].is_outlier);
  EXPECT_TRUE(panel().camera().text().contains("9 of 10")) << panel().camera().text().toStdString();
  panel().view().selectPick(3);
  QTest::keyClick(&panel().view(), Qt::Key_Delete);
  EXPECT_EQ(state().picked.size(), 9u);
}

TEST_F(Video, APickStaysWithItsPictureWhenTheSynchronisationChanges) {
  openInTime();
  pick(joints::Head);
  const PickedPoint before = state().picked.front();
  emit panel().sync().offsetEntered(state().sync.video_time(0) - 0.2);
  EXPECT_NEAR(state().picked.front().subject_s, before.subject_s + 0.2, 1e-9);
  const Vec3 there = desk().momentAt(before.subject_s + 0.2)->pose.row(joints::Head).transpose();
  EXPECT_LT((state().picked.front().world - there).norm(), 1e-12);
}

TEST_F(Video, WhatIsNoVideoIsTold) {
  const QString file = home().filePath("not.mp4");
  QFile text(file);
  ASSERT_TRUE(text.open(QIODevice::WriteOnly));
  text.write("this is a letter, not a film");
  text.close();
  window().openFiles({file});
  EXPECT_TRUE(until([] { return panel().view().notice().contains("not.mp4"); }))
      << panel().view().notice().toStdString();
  EXPECT_FALSE(panel().steps().isEnabled() && panel().sync().findChild<QPushButton*>()->isEnabled());
}

TEST_F(Video, IsRestoredByWhatAProjectKeeps) {
  openInTime();
  desk().changeCurrent([](VideoState& state) { state.camera = s_camera; }, "camera");
  const auto kept = window().document().project().videos;
  const auto& of = window().document().live().video_files();
  ASSERT_EQ(of.size(), 1U);
  const QStringList files{QString::fromStdString(of.front().absolute_path)};
  ASSERT_EQ(files, QStringList{s_file});
  desk().setVideos({}, {});
  EXPECT_FALSE(desk().current());
  desk().setVideos(kept, files);
  ASSERT_TRUE(until([] { return desk().shownPicture() != nullptr; }));
  EXPECT_EQ(window().document().project().videos, kept);
  EXPECT_TRUE(until([] { return !panel().view().overlay().empty(); })) << "the overlay is there again";
}

TEST_F(Video, AFileThatIsGoneIsToldAndWhatWasDecidedIsKept) {
  desk().setVideos({ProjectVideo{-1, "", {{{0.5, 0}}, 1}, {}, {}}}, {home().filePath("gone.mp4")});
  EXPECT_TRUE(until([] { return panel().view().notice().contains("gone.mp4"); }))
      << panel().view().notice().toStdString();
  EXPECT_EQ(window().document().project().videos.front().sync.points.size(), 1u);
}

TEST_F(Video, ClosingWhileItIsReadIsUndone) {
  window().openFiles({s_file});
  emit panel().closeRequested();
  EXPECT_FALSE(desk().current());
  EXPECT_FALSE(panel().view().picture());
  window().undoStack().undo();
  ASSERT_TRUE(until([] { return desk().shownPicture() != nullptr; }));
}

}  // namespace
}  // namespace abrazo::app::video_test
