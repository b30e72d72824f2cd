// The preview of retargeted takes: what it shows, and how soon.
#include "app/workbench/library/retarget_preview.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QToolButton>

#include "app/workbench/library/retarget_preview_desk.hpp"
#include "core/library/store/takes_of_library.hpp"
#include "tests/workbench/retarget_window.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app::retarget_preview_test {
namespace {

using ::testing::HasSubstr;

/// The preview of the dialog, whose player stands still.
class RetargetPreviewOfWindow : public RetargetWindow {
 protected:
  void SetUp() override {
    RetargetWindow::SetUp();
    frame("To frame").setValue(400);
    ASSERT_TRUE(complete());
    preview().ticker().pause();
    preview().setSide(RetargetPreview::Side::Both);
  }
  static RetargetPreview& preview() { return dialog().preview(); }
  static RetargetPreviewDesk& computing() { return desk().preview(); }
  static QLabel& state() { return *preview().findChild<QLabel*>("previewState"); }
  static bool complete() {
    return until([] { return !computing().isComputing() && computing().shown().recorded; });
  }
  /// A movement of the camera ends with the first picture after its fifth of a second.
  static void cameraComesToRest() {
    QTest::qWait(250);
    (void)preview().scene().picture();
  }
  static widgets::ValueSlider& slider(const QString& body) {
    return named<widgets::ValueSlider>(body + ": size");
  }
  static QToolButton& side(const QString& name) {
    for (auto* each : preview().findChildren<QToolButton*>())
      if (each->text() == name) return *each;
    throw std::invalid_argument(name.toStdString());
  }
  /// Parks there and waits until it is shown. @return the pair in the scene
  static PairPose shownAt(int frame) {
    const double time_s = computing().shown().time_of(static_cast<std::size_t>(frame));
    preview().ticker().seek(time_s);
    EXPECT_TRUE(until([&] {
      const auto& shown = preview().ticker().shown();
      return shown && shown->input_frame == frame && shown == preview().ticker().history()->at(time_s);
    }));
    return preview().ticker().shown()->result.result;
  }
  /// What is written of these choices.
  static TakeOnBodies written() {
    const auto wish = dialog().previewed();
    EXPECT_TRUE(wish);
    const auto takes = takes_of_library(*window().session()->material().library, wish->takes, "");
    EXPECT_TRUE(takes);
    auto made = retarget_take(takes->front(), *wish);
    EXPECT_TRUE(made);
    return *made;
  }
  static PairPose recording(int frame) {
    const RecordedPair& recorded = *computing().shown().recorded;
    PairPose pair;
    pair << recorded.active.poses[static_cast<std::size_t>(frame)],
        recorded.passive.poses[static_cast<std::size_t>(frame)];
    return pair;
  }
};

TEST_F(RetargetPreviewOfWindow, ShowsTheTakeAsItIsWrittenBesideTheRecording) {
  const TakeOnBodies made = written();
  for (const int frame : {0, 100, 333}) {
    EXPECT_EQ(shownAt(frame), made.pair.frames[static_cast<std::size_t>(frame)].pose) << frame;
    EXPECT_EQ(preview().ticker().shown()->result.selected_pair, recording(frame));
  }
  EXPECT_THAT(state().text().toStdString(), HasSubstr("Leader scale:0.9 ("));
  EXPECT_THAT(state().text().toStdString(), HasSubstr(made.described().quality_text()));
}

TEST_F(RetargetPreviewOfWindow, ItPlaysFromTheBeginningOfEveryTakeThatIsChosen) {
  (void)shownAt(200);
  dialog().chooseTakes({take(1)});
  ASSERT_TRUE(until([] {
    return computing().shown().recorded && computing().shown().recorded->name == take(1).toStdString();
  }));
  EXPECT_EQ(preview().ticker().playback().state, Playback::State::Playing);
  EXPECT_TRUE(until([] { return preview().ticker().playback().cursor_s > 0.3; }));
  EXPECT_LT(preview().ticker().playback().cursor_s, 200 / 60.0);
  EXPECT_TRUE(complete());
}

TEST_F(RetargetPreviewOfWindow, ASliderGivesABodyAnotherSizeAndFramesNearbyComeFirst) {
  const PairPose before = shownAt(150);
  int pieces = 0;
  const auto counting = QObject::connect(&preview().ticker(), &FrameTicker::frameReady, &preview(), [&] {
    for (const PreviewedPair::Piece& piece : computing().shown().pieces)
      if (piece.first > 0) ++pieces;
  });
  emit slider("Leader's body").moved(0.7, 1);
  EXPECT_EQ(body("Leader's body").currentText(), QString("scale:1.20"));
  EXPECT_TRUE(until([&] { return preview().ticker().shown()->result.result != before; }));
  QObject::disconnect(counting);
  EXPECT_GT(pieces, 0) << "a piece around the cursor, before the whole take";
  EXPECT_EQ(preview().ticker().playback().cursor_s, 150 / 60.0) << "the place stays";
  ASSERT_TRUE(complete());
  EXPECT_EQ(shownAt(150), written().pair.frames[150].pose);
  emit slider("Leader's body").resetRequested(2);
  EXPECT_EQ(body("Leader's body").currentText(), QString("library"));
  ASSERT_TRUE(complete());
  EXPECT_EQ(shownAt(150), recording(150)) << "both are as recorded";
  body("Leader's body").setEditText("scale:0.8");
  EXPECT_NEAR(slider("Leader's body").place(), 0.3, 1e-9) << "a typed size moves it as well";
}

TEST_F(RetargetPreviewOfWindow, AWeightChangesTheResult) {
  const PairPose before = shownAt(100);
  emit named<widgets::ValueSlider>("Contacts").moved(0, 1);
  EXPECT_TRUE(until([&] { return preview().ticker().shown()->result.result != before; }));
  ASSERT_TRUE(complete());
  EXPECT_EQ(shownAt(100), written().pair.frames[100].pose);
}

TEST_F(RetargetPreviewOfWindow, OfManySizesInARowTheLastOneStays) {
  for (int step = 1; step <= 20; ++step) {
    emit slider("Follower's body").moved(0.5 + 0.01 * step, 1);
    turn();
  }
  EXPECT_EQ(body("Follower's body").currentText(), QString("scale:1.20"));
  ASSERT_TRUE(complete());
  EXPECT_EQ(shownAt(40), written().pair.frames[40].pose);
}

TEST_F(RetargetPreviewOfWindow, ATallerBodyStaysInThePicture) {
  body("Leader's body").setEditText("library");
  ASSERT_TRUE(complete());
  (void)shownAt(60);
  const auto distance_m = [] { return preview().scene().camera().distance_m; };
  preview().scene().frameAll();
  cameraComesToRest();
  const double before_m = distance_m();
  body("Leader's body").setEditText("scale:1.50");
  EXPECT_TRUE(until([&] { return distance_m() > 1.2 * before_m; }));
  ASSERT_TRUE(complete());
  EXPECT_TRUE(until([&] {
    return preview().scene().roomFor(preview().ticker().shown()->result.result) >= 0.98;
  })) << "a head is behind the buttons";
}

TEST_F(RetargetPreviewOfWindow, AAndBExchangeTheRecordingAndTheResult) {
  const PairPose made = shownAt(60);
  ASSERT_NE(made, recording(60));
  side("A: recording").click();
  EXPECT_EQ(shownAt(60), recording(60));
  side("B: other bodies").click();
  EXPECT_EQ(shownAt(60), made);
  side("Both").click();
  EXPECT_EQ(shownAt(60), made);
}

TEST_F(RetargetPreviewOfWindow, ThePicturesOfAAndBDiffer) {
  body("Leader's body").setEditText("scale:1.3");
  ASSERT_TRUE(complete());
  (void)shownAt(60);
  preview().scene().setFollowing(false);  // the camera would still come nearer
  cameraComesToRest();                    // it went back for the taller leader
  const auto picture = [](RetargetPreview::Side side) {
    preview().setSide(side);
    (void)shownAt(60);
    return preview().scene().picture();
  };
  const auto pixels_unlike = [](const QImage& a, const QImage& b) {
    int unlike = 0;
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x) unlike += a.pixel(x, y) != b.pixel(x, y);
    return unlike;
  };
  const QImage recorded = picture(RetargetPreview::Side::Recording);
  const QImage made = picture(RetargetPreview::Side::Retargeted);
  ASSERT_EQ(recorded.size(), made.size());
  const int whole = made.width() * made.height();
  EXPECT_GT(pixels_unlike(recorded, made), whole / 100) << "a leader who is 30 % taller";
  EXPECT_GT(pixels_unlike(made, picture(RetargetPreview::Side::Both)), whole / 500)
      << "lines of the recording";
  EXPECT_EQ(pixels_unlike(made, picture(RetargetPreview::Side::Retargeted)), 0) << "the same again";
  preview().scene().setFollowing(true);
}

TEST_F(RetargetPreviewOfWindow, WhatCannotBeShownIsSaidAndTheNextChoiceIsShownAgain) {
  body("Leader's body").setEditText("scale:9");
  EXPECT_THAT(state().text().toStdString(), HasSubstr("a number from 0.3 to 3 is expected"));
  EXPECT_FALSE(preview().isEnabled());
  body("Leader's body").setEditText(QDir(output).filePath("gone.bvh"));
  EXPECT_TRUE(until([] { return state().text().contains("gone.bvh"); }));
  body("Leader's body").setEditText("scale:1.1");
  ASSERT_TRUE(complete());
  EXPECT_TRUE(preview().isEnabled());
  EXPECT_EQ(shownAt(10), written().pair.frames[10].pose);
  dialog().chooseTakes({});
  EXPECT_THAT(state().text().toStdString(), HasSubstr("Choose a take"));
}

TEST_F(RetargetPreviewOfWindow, WhatFailsLateDoesNotStopTheNextChoice) {
  body("Leader's body").setEditText(QDir(output).filePath("gone.bvh"));
  ASSERT_TRUE(computing().isComputing());
  body("Leader's body").setEditText("scale:1.1");
  ASSERT_TRUE(complete());
  EXPECT_EQ(shownAt(10), written().pair.frames[10].pose);
}

TEST_F(RetargetPreviewOfWindow, NothingIsComputedForADialogThatIsHidden) {
  emit slider("Leader's body").moved(0.8, 1);
  dialog().hide();
  EXPECT_FALSE(computing().isComputing());
  EXPECT_FALSE(preview().ticker().history()) << "nothing plays";
  body("Leader's body").setEditText("scale:0.7");
  turn();
  EXPECT_FALSE(computing().isComputing());
}

}  // namespace
}  // namespace abrazo::app::retarget_preview_test
