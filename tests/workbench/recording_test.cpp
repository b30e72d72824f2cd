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
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/scene_picture.hpp"
#include "tests/widgets/pictures.hpp"
#include "tests/workbench/until.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app::recording_test {
namespace {

class Recording : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    s_home = new QTemporaryDir;
    qputenv("ABRAZO_HOME", s_home->path().toUtf8());
    s_remembered = new UserSettings;
    s_window = new MainWindow(*s_remembered);
    s_window->setTheme(widgets::Theme::Dark);
    s_window->resize(1100, 700);
    add_all_actions(*s_window);
    s_window->show();
    s_window->openDemo();
    until([] { return s_window->ticker().playback().last_s > 2; });
  }
  static void TearDownTestSuite() {
    delete s_window;
    delete s_remembered;
    delete s_home;
  }
  void SetUp() override { ASSERT_TRUE(s_window->ticker().shown()) << "the demo did not start"; }

  static QString text() { return s_window->messages().text(); }
  static QLabel* mark() {
    for (auto* label : s_window->statusBar()->findChildren<QLabel*>())
      if (label->accessibleName() == "Recording") return label;
    return nullptr;
  }
  static RangeRequest request(const QString& file) { return {{0.5, 1.0, 12}, {480, 320}, true, file}; }
  static FrameRange frames() { return s_window->ticker().history()->stretch(0.4, 1.1); }

  static inline MainWindow* s_window = nullptr;
  static inline UserSettings* s_remembered = nullptr;
  static inline QTemporaryDir* s_home = nullptr;
};

TEST_F(Recording, TheViewIsFilmedUntilItIsStoppedWithAMarkMeanwhile) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("view.mp4");
  auto* recording = s_window->findChild<ViewRecording*>("viewRecording");
  ASSERT_TRUE(recording);
  start_recording(*s_window, *recording, file);
  ASSERT_TRUE(recording->isRunning()) << text().toStdString();
  EXPECT_TRUE(until([&] { return recording->elapsed_s() > 0.6 && mark()->isVisible(); }));
  EXPECT_TRUE(mark()->text().contains("REC"));
  EXPECT_FALSE(QFile::exists(file)) << "whole or not at all";
  QAction* stop = nullptr;
  for (QAction* action : s_window->actions())
    if (action->text() == "Stop recording") stop = action;
  ASSERT_TRUE(stop);
  stop->trigger();
  EXPECT_TRUE(until([&] { return text().contains(file); })) << text().toStdString();
  EXPECT_TRUE(QFile::exists(file));
  EXPECT_FALSE(mark()->isVisible());
  EXPECT_EQ(stop->text(), "Record view…");
}

TEST_F(Recording, AFilmThatCannotBeWrittenSaysWhy) {
  auto* recording = s_window->findChild<ViewRecording*>("viewRecording");
  start_recording(*s_window, *recording, "/no/such/folder/view.mp4");
  EXPECT_FALSE(recording->isRunning());
  EXPECT_TRUE(text().contains("check that the folder exists")) << text().toStdString();
}

TEST_F(Recording, ARangeIsFilmedWholeWhileTheWindowGoesOn) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("range.mp4");
  const auto before = s_window->ticker().shown()->index;
  render_range(*s_window, request(file));
  EXPECT_TRUE(until([] { return text().contains("Rendering picture"); }));
  EXPECT_TRUE(until([&] { return text().contains("Video written to " + file); })) << text().toStdString();
  EXPECT_TRUE(QFile::exists(file));
  EXPECT_GT(s_window->ticker().shown()->index, before);
}

TEST_F(Recording, ACancelledRangeLeavesNothing) {
  const QTemporaryDir folder;
  render_range(*s_window, request(folder.filePath("range.mp4")));
  EXPECT_TRUE(until([] { return text().contains("Rendering picture"); }));
  emit s_window->messages().cancelRequested();
  QTest::qWait(50);
  EXPECT_TRUE(text().contains("cancelled"));
  EXPECT_TRUE(QDir(folder.path()).isEmpty());
  EXPECT_FALSE(s_window->findChild<RangeRendering*>());
}

TEST_F(Recording, TheSameFramesGiveTheSamePictures) {
  const QTemporaryDir folder;
  s_window->ticker().seek(0.7);
  QTest::qWait(50);
  std::vector<QImage> pictures[2];
  for (std::vector<QImage>& made : pictures) {
    RangeRendering rendering(frames(), nullptr);
    ASSERT_EQ(rendering.start(request(folder.filePath("range.mp4")), s_window->scene()), QString());
    for (const double time_s : {0.5, 0.6, 0.9}) made.push_back(rendering.picture(time_s).copy());
  }
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(pictures[0][i].size(), QSize(480, 320));
    EXPECT_EQ(test::difference(pictures[0][i], pictures[1][i]), 0);
  }
  EXPECT_GT(test::difference(pictures[0][0], pictures[0][2]), 0.001) << "they move";
  EXPECT_GT(test::pixels_of_hue(pictures[0][0], s_window->colours().active, 12), 150);
  EXPECT_GT(test::pixels_of_hue(pictures[0][0], s_window->colours().passive, 12), 150);
  s_window->ticker().follow();
}

TEST_F(Recording, ThePictureWithoutBackgroundHoldsTheBodiesWholeAndNothingAround) {
  const QImage picture = transparent_picture(s_window->scene());
  int whole = 0, nothing = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QColor here = picture.pixelColor(x, y);
      whole += here.alpha() == 255 && here.hsvSaturation() > 90;
      nothing += here.alpha() == 0;
    }
  EXPECT_GT(whole, 1500);
  EXPECT_GT(nothing, picture.width() * picture.height() / 3);
  const QImage after = s_window->scene().picture();
  EXPECT_GT(test::pixels_like(after, s_window->colours().scene_top, 10), 100) << "the view has its own again";
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
