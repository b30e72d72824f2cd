// What the panel of takes shows and asks for, and the countdown over the scene.
#include "widgets/takes/take_panel.hpp"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

#include "tests/widgets/pictures.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/takes/countdown.hpp"
#include "widgets/takes/take_rows.hpp"

namespace abrazo::widgets::take_panel_test {
namespace {

using Phase = TakeSequence::Phase;
using test::picture_of;
using test::pixels_like;

class Takes : public testing::Test {
 protected:
  Takes() {
    panel.resize(300, 520);
    panel.setTakes(takes);
    panel.showStatus(status);
    panel.show();
  }

  RecordedTakes takes{
      {{1, "salsa 001", 2, 37, 4200, {"Ana"}}, {4, "salsa 002", 40, 52, 1440, {"Ana", "Ben"}}}};
  RecordingStatus status = [] {
    RecordingStatus ready;
    ready.can_record = true;
    return ready;
  }();
  TakePanel panel;
};

TEST_F(Takes, TheNextNameFollowsWhatIsTyped) {
  panel.setTypedName("salsa");
  EXPECT_EQ(panel.nextName(), "salsa 003");
  QTest::keyClicks(panel.findChild<QLineEdit*>(), "X");
  EXPECT_EQ(panel.nextName(), "salsaX 001");
}

TEST_F(Takes, TheButtonIsRedAndSaysWhatItDoes) {
  const QColor red = palette_of(Theme::Dark).live;
  EXPECT_GT(pixels_like(picture_of(panel.recordButton()), red), 2000);
  EXPECT_EQ(panel.recordButton().text().trimmed(), "Record");
  QSignalSpy asked(&panel, &TakePanel::recordRequested);
  panel.recordButton().click();
  EXPECT_EQ(asked.count(), 1);
  status.phase = Phase::Recording;
  status.elapsed_s = 35.4;
  panel.showStatus(status);
  EXPECT_EQ(panel.recordButton().text().trimmed(), "Stop");
  EXPECT_EQ(panel.elapsedText(), "● 00:35");
  status.phase = Phase::CountingDown;
  panel.showStatus(status);
  EXPECT_EQ(panel.recordButton().text().trimmed(), "Cancel");
}

TEST_F(Takes, NothingCanBeRecordedWithoutASessionNorDoneAgainWithoutATake) {
  panel.setTakes(RecordedTakes());
  panel.showStatus(status);
  EXPECT_TRUE(panel.recordButton().isEnabled());
  EXPECT_FALSE(panel.againButton().isEnabled());
  panel.showStatus({});
  EXPECT_FALSE(panel.recordButton().isEnabled());
}

TEST_F(Takes, AFailureOfTheDiskIsSaidInRedAndNotByColourAlone) {
  status.failure = "s.abrazo: no space left on the disk; free some";
  status.lost = 7;
  panel.showStatus(status);
  EXPECT_TRUE(panel.diskText().startsWith("⚠"));
  EXPECT_TRUE(panel.diskText().contains("7 frames lost"));
}

TEST_F(Takes, ADoubleClickAndReturnGoToATake) {
  QSignalSpy asked(&panel, &TakePanel::goToRequested);
  panel.rows().setCurrentRow(1);
  QTest::keyClick(&panel.rows(), Qt::Key_Return);
  ASSERT_EQ(asked.count(), 1);
  EXPECT_EQ(asked[0][0].toLongLong(), 4);
  const QPoint first = panel.rows().visualItemRect(panel.rows().item(0)).center();
  QTest::mouseClick(panel.rows().viewport(), Qt::LeftButton, {}, first);
  QTest::mouseDClick(panel.rows().viewport(), Qt::LeftButton, {}, first);
  ASSERT_GE(asked.count(), 2);
  EXPECT_EQ(asked.back()[0].toLongLong(), 1);
}

TEST_F(Takes, FTwoRenamesAndWaitsForTheAnswer) {
  QSignalSpy asked(&panel, &TakePanel::renameRequested);
  panel.rows().setCurrentRow(0);
  panel.rows().setFocus();
  QTest::keyClick(&panel.rows(), Qt::Key_F2);
  auto* editor = panel.rows().viewport()->findChild<QLineEdit*>();
  ASSERT_NE(editor, nullptr);
  editor->selectAll();
  QTest::keyClicks(editor, "warm-up");
  QTest::keyClick(editor, Qt::Key_Return);
  QCoreApplication::processEvents();  // the editor is done after the key
  ASSERT_EQ(asked.count(), 1);
  EXPECT_EQ(asked[0][0].toLongLong(), 1);
  EXPECT_EQ(asked[0][1].toString(), "warm-up");
  EXPECT_EQ(panel.rows().item(0)->text(), "salsa 001");
  takes.rename(1, "warm-up");
  panel.setTakes(takes);
  EXPECT_EQ(panel.rows().item(0)->text(), "warm-up");
}

TEST_F(Takes, DeleteAsksAndTheRowsKeepWhichOneIsChosen) {
  QSignalSpy asked(&panel, &TakePanel::removeRequested);
  panel.rows().setCurrentRow(1);
  QTest::keyClick(&panel.rows(), Qt::Key_Delete);
  ASSERT_EQ(asked.count(), 1);
  EXPECT_EQ(asked[0][0].toLongLong(), 4);
  takes.remove(1);
  panel.setTakes(takes);
  EXPECT_EQ(panel.rows().currentTake(), 4);
}

TEST_F(Takes, TheTickOfKeepingEverythingWaitsForTheAnswer) {
  QSignalSpy asked(&panel, &TakePanel::everythingRequested);
  auto* tick = panel.findChild<QCheckBox*>();
  tick->click();
  ASSERT_EQ(asked.count(), 1);
  EXPECT_TRUE(asked[0][0].toBool());
  EXPECT_FALSE(tick->isChecked());
  status.is_everything_kept = true;
  panel.showStatus(status);
  EXPECT_TRUE(tick->isChecked());
}

TEST_F(Takes, EveryPartHasANameForThoseWhoDoNotSeeIt) {
  for (const QWidget* part : panel.findChildren<QPushButton*>())
    EXPECT_FALSE(part->accessibleName().isEmpty() && static_cast<const QPushButton*>(part)->text().isEmpty());
  EXPECT_EQ(panel.findChild<QSpinBox*>()->accessibleName(), "Countdown before a take");
  EXPECT_EQ(panel.rows().accessibleName(), "Takes of this session");
}

TEST(CountdownOverTheScene, IsLargeAndGoesWhenItIsOver) {
  QWidget scene;
  scene.resize(640, 480);
  scene.show();
  Countdown countdown(&scene);
  countdown.showCount(3, "salsa 003");
  EXPECT_TRUE(countdown.isVisible());
  EXPECT_EQ(countdown.geometry().center().x(), 319);
  const QImage three = picture_of(countdown);
  countdown.showCount(2, "salsa 003");
  EXPECT_GT(test::difference(three, picture_of(countdown)), 0.02);
  countdown.showCount(0, {});
  EXPECT_FALSE(countdown.isVisible());
}

}  // namespace
}  // namespace abrazo::widgets::take_panel_test
