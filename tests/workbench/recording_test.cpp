// Films of the view and of what was recorded, in the whole window.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>

#include "app/workbench/base/range_rendering.hpp"
#include "app/workbench/base/render_dialog.hpp"
#include "app/workbench/export/view_recording.hpp"
#include "app/workbench/shell/scene_picture.hpp"
#include "tests/widgets/pictures.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app::recording_test {
namespace {

class Recording : public DemoWindow {
 protected:
  static void SetUpTestSuite() {
    showDemo({1100, 700});
    until([] { return ticker().playback().last_s > 2; });
  }
  void SetUp() override { ASSERT_TRUE(window().ticker().shown()) << "the demo did not start"; }

  static QString text() { return window().messages().text(); }
  static QLabel* mark() {
    for (auto* label : window().statusBar()->findChildren<QLabel*>())
      if (label->accessibleName() == "Recording") return label;
    return nullptr;
  }
  static RangeRequest request(const QString& file) { return {{0.5, 1.0, 12}, {480, 320}, true, file}; }
  static FrameRange frames() { return window().ticker().history()->stretch(0.4, 1.1); }
};

TEST_F(Recording, TheViewIsFilmedUntilItIsStoppedWithAMarkMeanwhile) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("view.mp4");
  auto* recording = window().findChild<ViewRecording*>("viewRecording");
  ASSERT_TRUE(recording);
  recording->start(file);
  EXPECT_FALSE(recording->isRunning()) << "the encoder is loaded elsewhere, the window goes on";
  EXPECT_TRUE(recording->isBusy());
  ASSERT_TRUE(until([&] { return recording->isRunning(); })) << text().toStdString();
  EXPECT_TRUE(until([&] { return recording->elapsed_s() > 0.6 && mark()->isVisible(); }));
  EXPECT_TRUE(mark()->text().contains("REC"));
  EXPECT_FALSE(QFile::exists(file)) << "whole or not at all";
  QAction* stop = nullptr;
  for (QAction* action : window().actions())
    if (action->text() == "Stop recording") stop = action;
  ASSERT_TRUE(stop);
  stop->trigger();
  EXPECT_TRUE(until([&] { return text().contains(file); })) << text().toStdString();
  EXPECT_TRUE(QFile::exists(file));
  EXPECT_FALSE(mark()->isVisible());
  EXPECT_EQ(stop->text(), "Record view…");
}

TEST_F(Recording, AFilmThatCannotBeWrittenSaysWhy) {
  auto* recording = window().findChild<ViewRecording*>("viewRecording");
  recording->start("/no/such/folder/view.mp4");
  EXPECT_TRUE(until([&] { return !recording->isBusy(); }));
  EXPECT_FALSE(recording->isRunning());
  EXPECT_TRUE(text().contains("check that the folder exists")) << text().toStdString();
}

TEST_F(Recording, ARangeIsFilmedWholeWhileTheWindowGoesOn) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("range.mp4");
  const auto before = window().ticker().shown()->index;
  render_range(window(), request(file));
  EXPECT_TRUE(until([] { return text().contains("Rendering picture"); }));
  EXPECT_TRUE(until([&] { return text().contains("Video written to " + file); })) << text().toStdString();
  EXPECT_TRUE(QFile::exists(file));
  EXPECT_GT(window().ticker().shown()->index, before);
}

TEST_F(Recording, ACancelledRangeLeavesNothing) {
  const QTemporaryDir folder;
  render_range(window(), request(folder.filePath("range.mp4")));
  EXPECT_TRUE(until([] { return text().contains("Rendering picture"); }));
  emit window().messages().cancelRequested();
  QTest::qWait(50);
  EXPECT_TRUE(text().contains("cancelled"));
  EXPECT_TRUE(QDir(folder.path()).isEmpty());
  EXPECT_FALSE(window().findChild<RangeRendering*>());
}

TEST_F(Recording, TheSameFramesGiveTheSamePictures) {
  const QTemporaryDir folder;
  window().ticker().seek(0.7);
  QTest::qWait(50);
  std::vector<QImage> pictures[2];
  for (std::vector<QImage>& made : pictures) {
    RangeRendering rendering(frames(), nullptr);
    ASSERT_EQ(rendering.start(request(folder.filePath("range.mp4")), window().scene()), QString());
    for (const double time_s : {0.5, 0.6, 0.9}) made.push_back(rendering.picture(time_s).copy());
  }
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(pictures[0][i].size(), QSize(480, 320));
    EXPECT_EQ(test::difference(pictures[0][i], pictures[1][i]), 0);
  }
  EXPECT_GT(test::difference(pictures[0][0], pictures[0][2]), 0.001) << "they move";
  EXPECT_GT(test::pixels_of_hue(pictures[0][0], window().colours().active, 12), 150);
  EXPECT_GT(test::pixels_of_hue(pictures[0][0], window().colours().passive, 12), 150);
  window().ticker().follow();
}

TEST_F(Recording, ThePictureWithoutBackgroundHoldsTheBodiesWholeAndNothingAround) {
  const QImage picture = transparent_picture(window().scene());
  int whole = 0, nothing = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QColor here = picture.pixelColor(x, y);
      whole += here.alpha() == 255 && here.hsvSaturation() > 90;
      nothing += here.alpha() == 0;
    }
  EXPECT_GT(whole, 1500);
  EXPECT_GT(nothing, picture.width() * picture.height() / 3);
  const QImage after = window().scene().picture();
  EXPECT_GT(test::pixels_like(after, window().colours().scene_top, 10), 100) << "the view has its own again";
}

TEST_F(Recording, TheDialogOffersTheRangeTheWholeAndSizes) {
  RenderDialog dialog(nullptr);
  Playback playback;
  playback.first_s = 1;
  playback.last_s = 11;
  dialog.offer(playback, Playback::Range{2, 4}, {801, 601});
  RangeRequest asked = dialog.request();
  EXPECT_EQ(asked.plan.from_s, 2);
  EXPECT_EQ(asked.plan.pictures(), 61);
  EXPECT_EQ(asked.size, QSize(1280, 720));
  dialog.offer(playback, {}, {801, 601});
  EXPECT_EQ(dialog.request().plan.pictures(), 301);
  dialog.findChild<QDoubleSpinBox*>()->setValue(24);
  dialog.offer(playback, {}, {801, 601});
  EXPECT_EQ(dialog.request().plan.rate_hz, 24) << "as it was typed";
  auto* what = dialog.findChild<QComboBox*>();
  dialog.offerVideo({640, 480}, 50);
  what->setCurrentIndex(1);
  EXPECT_EQ(dialog.request().plan.rate_hz, 50) << "a video has its own";
  dialog.offer(playback, {}, {801, 601});
  what->setCurrentIndex(0);
  EXPECT_EQ(dialog.request().plan.rate_hz, 24);
}

}  // namespace
}  // namespace abrazo::app::recording_test
