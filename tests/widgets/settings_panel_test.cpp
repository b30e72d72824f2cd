#include "widgets/settings/settings_panel.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>

#include "tests/widgets/pictures.hpp"
#include "widgets/common/value_slider.hpp"
#include "widgets/settings/preset_bar.hpp"
#include "widgets/settings/setting_row.hpp"
#include "widgets/settings/toggle.hpp"

namespace abrazo::widgets::settings_panel_test {
namespace {

struct Panel {
  QUndoStack undo;
  SettingsPanel panel{undo};
  std::vector<Settings> sent;
  QString mistake;
  Panel() {
    QObject::connect(&panel, &SettingsPanel::commandRequested, [this](const Command& command) {
      sent.push_back(std::get<SetSettings>(command).settings);
    });
    QObject::connect(&panel, &SettingsPanel::mistaken, [this](const QString& text) { mistake = text; });
  }
};

TEST(SettingsPanel, SendsTheWholeValueAtOnce) {
  Panel p;
  p.panel.change("alpha", "0.7");
  ASSERT_EQ(p.sent.size(), 1u);
  Settings wanted = preset("paper").value();
  wanted.alpha = 0.7;
  EXPECT_EQ(p.sent[0], wanted);
}

TEST(SettingsPanel, OneDragIsOneStepOfUndo) {
  Panel p;
  const Settings before = p.panel.settings();
  for (const char* value : {"0.6", "0.7", "0.8"}) p.panel.change("alpha", value, 1);
  EXPECT_EQ(p.undo.count(), 1);
  EXPECT_EQ(p.sent.size(), 3u) << "every move goes to the solver";
  p.undo.undo();
  EXPECT_EQ(p.panel.settings(), before);
  p.undo.redo();
  EXPECT_DOUBLE_EQ(p.panel.settings().alpha, 0.8);
}

TEST(SettingsPanel, TwoDragsAreTwoSteps) {
  Panel p;
  p.panel.change("alpha", "0.6", 1);
  p.panel.change("alpha", "0.7", 2);
  EXPECT_EQ(p.undo.count(), 2);
}

TEST(SettingsPanel, AnEntryThatCannotBeUsedChangesNothingAndSaysWhy) {
  Panel p;
  const Settings before = p.panel.settings();
  p.panel.change("alpha", "much");
  EXPECT_EQ(p.panel.settings(), before);
  EXPECT_TRUE(p.sent.empty());
  EXPECT_TRUE(p.mistake.contains("alpha")) << p.mistake.toStdString();
}

TEST(SettingsPanel, APresetCanBeUndone) {
  Panel p;
  p.panel.choosePreset("responsive");
  EXPECT_EQ(p.panel.settings(), preset("responsive").value());
  p.undo.undo();
  EXPECT_EQ(p.panel.settings(), preset("paper").value());
}

struct ShownPanel : Panel {
  ShownPanel() {
    panel.setColours(palette_of(Theme::Dark));
    panel.resize(340, 900);
    panel.show();
    (void)QTest::qWaitForWindowExposed(&panel, 1000);
  }
  SettingRow& row(const char* key) {
    for (SettingRow* row : panel.findChildren<SettingRow*>())
      if (row->info().key == key) return *row;
    throw std::invalid_argument(key);
  }
  ValueSlider& slider(const char* key) { return *row(key).findChild<ValueSlider*>(); }
  QLineEdit& field(const char* key) { return *row(key).findChild<QLineEdit*>(); }
  QString title(const char* key) { return row(key).findChild<QLabel*>()->text(); }
};

void drag(ValueSlider& slider, const std::vector<int>& to) {
  const int y = 8;
  QTest::mousePress(&slider, Qt::LeftButton, {}, {static_cast<int>(slider.handleX()), y});
  for (const int x : to) {
    QMouseEvent move(QEvent::MouseMove, QPointF(x, y), QPointF(x, y), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&slider, &move);
  }
  QTest::mouseRelease(&slider, Qt::LeftButton, {}, {to.empty() ? 0 : to.back(), y});
}

TEST(SettingsPanel, DraggingWithTheMouseIsOneStepOfUndo) {
  ShownPanel p;
  drag(p.slider("alpha"), {120, 140, 160, 200});
  EXPECT_EQ(p.undo.count(), 1);
  EXPECT_GE(p.sent.size(), 4u) << "every move goes to the solver";
  EXPECT_GT(p.panel.settings().alpha, 2);
  EXPECT_EQ(p.undo.undoText(),
            "temporal smoothness to " + QString::fromStdString(setting_text(p.panel.settings(), "alpha")));
  p.undo.undo();
  EXPECT_EQ(p.panel.settings(), *preset("paper"));
  drag(p.slider("alpha"), {150});
  drag(p.slider("alpha"), {180});
  EXPECT_EQ(p.undo.count(), 2) << "two drags";
}

TEST(SettingsPanel, ADragThatEndsWhereItBeganIsNoStep) {
  ShownPanel p;
  const int home = static_cast<int>(p.slider("alpha").handleX());
  drag(p.slider("alpha"), {200, home});
  EXPECT_EQ(p.undo.count(), 0);
  EXPECT_EQ(p.panel.settings(), *preset("paper"));
}

TEST(SettingsPanel, TakingTheHandleDoesNotMoveIt) {
  ShownPanel p;
  const int home = static_cast<int>(p.slider("velocity-weight").handleX());
  QTest::mouseClick(&p.slider("velocity-weight"), Qt::LeftButton, {}, {home + 3, 8});
  EXPECT_TRUE(p.sent.empty());
}

TEST(SettingsPanel, ADoubleClickGoesBackToTheDefaultInOneStep) {
  ShownPanel p;
  p.panel.change("alpha", "1.5");
  QTest::mousePress(&p.slider("alpha"), Qt::LeftButton, {}, {250, 8});
  QTest::mouseRelease(&p.slider("alpha"), Qt::LeftButton, {}, {250, 8});
  QTest::mouseDClick(&p.slider("alpha"), Qt::LeftButton, {}, {250, 8});
  EXPECT_EQ(p.panel.settings().alpha, 0.5);
  p.undo.undo();
  EXPECT_EQ(p.panel.settings().alpha, 1.5);
}

TEST(SettingsPanel, ArrowKeysStepAndAHeldKeyIsOneStepOfUndo) {
  ShownPanel p;
  ValueSlider& slider = p.slider("neighbours");
  slider.setFocus();
  QTest::keyClick(&slider, Qt::Key_Right);
  EXPECT_EQ(p.panel.settings().neighbours, 11);
  QTest::keyClick(&slider, Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_EQ(p.panel.settings().neighbours, 1);
  EXPECT_EQ(p.undo.count(), 2);
  QTest::keyPress(&slider, Qt::Key_Up);
  for (int repeat = 0; repeat < 3; ++repeat) {
    QKeyEvent held(QEvent::KeyPress, Qt::Key_Up, {}, {}, true);
    QApplication::sendEvent(&slider, &held);
  }
  EXPECT_EQ(p.panel.settings().neighbours, 5);
  EXPECT_EQ(p.undo.count(), 3);
  QTest::keyClick(&slider, Qt::Key_Backspace);
  EXPECT_EQ(p.panel.settings().neighbours, 10);
}

TEST(SettingsPanel, AValueCanBeTypedWithOrWithoutItsUnit) {
  ShownPanel p;
  QLineEdit& field = p.field("foot-lock-speed");
  QTest::mouseClick(&field, Qt::LeftButton);
  QTest::keyClicks(&field, "0.25 m/s");
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(p.panel.settings().foot_lock_speed, 0.25);
  EXPECT_EQ(field.text(), "0.25 m/s");
}

TEST(SettingsPanel, SwitchesAndListsWorkByKeyAndAreSteps) {
  ShownPanel p;
  Toggle& locks = *p.row("foot-locks").findChild<Toggle*>();
  locks.setFocus();
  QTest::keyClick(&locks, Qt::Key_Space);
  EXPECT_FALSE(p.panel.settings().foot_locks);
  QTest::keyClick(&locks, Qt::Key_Space);
  EXPECT_TRUE(p.panel.settings().foot_locks);
  QComboBox& form = *p.row("velocity-form").findChild<QComboBox*>();
  QTest::keyClick(&form, Qt::Key_Down);
  EXPECT_EQ(p.panel.settings().velocity_form, VelocityForm::Predicted);
  EXPECT_EQ(p.undo.count(), 3);
}

TEST(SettingsPanel, EveryControlHasANameAndADescription) {
  ShownPanel p;
  for (SettingRow* row : p.panel.findChildren<SettingRow*>()) {
    EXPECT_FALSE(row->toolTip().isEmpty());
    for (QWidget* control : row->findChildren<QWidget*>()) {
      if (control->focusPolicy() == Qt::NoFocus || control->parentWidget() != row) continue;
      EXPECT_FALSE(control->accessibleName().isEmpty())
          << row->info().key << control->metaObject()->className();
      EXPECT_FALSE(control->accessibleDescription().isEmpty()) << row->info().key;
    }
  }
  for (QToolButton* segment : p.panel.presets().findChildren<QToolButton*>())
    EXPECT_FALSE(segment->accessibleName().isEmpty());
}

TEST(SettingsPanel, AStarMarksThePresetAndTheRowThatWereChanged) {
  ShownPanel p;
  EXPECT_FALSE(p.title("alpha").contains("*"));
  p.panel.change("alpha", "0.7");
  EXPECT_TRUE(p.title("alpha").contains("*"));
  EXPECT_FALSE(p.title("morph-steps").contains("*"));
  EXPECT_EQ(p.panel.presets().findChildren<QToolButton*>().front()->text(), "paper *");
  p.panel.choosePreset("responsive");
  EXPECT_EQ(p.panel.presets().findChildren<QToolButton*>().front()->text(), "paper");
  p.undo.undo();
  EXPECT_EQ(p.panel.presets().findChildren<QToolButton*>().front()->text(), "paper *");
}

TEST(SettingsPanel, GreysWhatDoesNotCountWithTheMethodOfSelectionAndSaysWhoseItIs) {
  ShownPanel p;
  EXPECT_TRUE(p.slider("continuations").isEnabled());
  EXPECT_FALSE(p.slider("transition-time").isEnabled());
  EXPECT_TRUE(p.row("transition-time").toolTip().contains("Only with the playback continuous"));
  EXPECT_FALSE(p.slider("switch-margin").isEnabled());
  EXPECT_TRUE(p.row("switch-margin").toolTip().contains("Only with the method intent"));
  QTest::keyClick(p.row("selection").findChild<QComboBox*>(), Qt::Key_Down);
  EXPECT_EQ(p.panel.settings().selection, SelectionMethod::Intent);
  EXPECT_TRUE(p.slider("switch-margin").isEnabled());
  EXPECT_FALSE(p.row("switch-margin").toolTip().contains("Only with"));
  EXPECT_FALSE(p.slider("continuations").isEnabled());
  EXPECT_TRUE(p.row("continuations").toolTip().contains("Only with the method paper"));
  EXPECT_TRUE(p.slider("alpha").isEnabled()) << "both have it";
  p.undo.undo();
  EXPECT_TRUE(p.slider("continuations").isEnabled());
}

TEST(SettingsPanel, TheFilterLeavesTheRowsWithItsWords) {
  ShownPanel p;
  p.panel.filter("foot");
  EXPECT_TRUE(p.row("foot-locks").isVisible());
  EXPECT_FALSE(p.row("alpha").isVisible());
  p.panel.filter("no such thing");
  EXPECT_FALSE(p.row("foot-locks").isVisible());
  p.panel.filter("");
  EXPECT_TRUE(p.row("alpha").isVisible());
}

TEST(SettingsPanel, TellsWhatAShownFrameWasSolvedWithAndTakesItOverInOneStep) {
  ShownPanel p;
  auto* use = p.panel.findChild<QPushButton*>("useFrameSettings");
  EXPECT_FALSE(use->isVisible());
  Settings of_frame = *preset("paper");
  of_frame.alpha = 2;
  of_frame.foot_locks = false;
  const QImage before = p.slider("alpha").grab().toImage();
  p.panel.showFrameSettings(of_frame);
  EXPECT_TRUE(use->isVisible());
  EXPECT_TRUE(p.title("alpha").contains("2"));
  EXPECT_TRUE(p.title("foot-locks").contains("off"));
  EXPECT_FALSE(p.title("morph-steps").contains("span")) << "only what differs";
  const QImage marked = p.slider("alpha").grab().toImage();
  EXPECT_GT(test::pixels_of_hue(marked, palette_of(Theme::Dark).warning),
            test::pixels_of_hue(before, palette_of(Theme::Dark).warning) + 20)
      << "the mark on the slider";
  QTest::mouseClick(use, Qt::LeftButton);
  EXPECT_EQ(p.panel.settings(), of_frame);
  EXPECT_FALSE(use->isVisible());
  EXPECT_EQ(p.undo.count(), 1);
  p.undo.undo();
  EXPECT_EQ(p.panel.settings(), *preset("paper"));
  EXPECT_TRUE(use->isVisible());
  p.panel.showFrameSettings(std::nullopt);
  EXPECT_FALSE(use->isVisible());
}

TEST(SettingsPanel, OwnPresetsCanBeChosenAndAreDefaultsThen) {
  ShownPanel p;
  Settings calm = *preset("paper");
  calm.alpha = 2;
  p.panel.setOwnPresets({{"calm", calm}});
  p.panel.chooseOwnPreset("calm");
  EXPECT_EQ(p.panel.settings(), calm);
  EXPECT_TRUE(p.panel.choice().own);
  p.panel.change("alpha", "1");
  EXPECT_TRUE(p.title("alpha").contains("*"));
  QMenu menu;
  p.panel.presets().fillMenu(menu);
  QStringList offered;
  for (const QAction* action : menu.actions()) offered << action->text();
  EXPECT_TRUE(offered.contains("calm"));
  EXPECT_TRUE(offered.join("|").contains("Rename")) << offered.join("|").toStdString();
  p.panel.setOwnPresets({});
  EXPECT_FALSE(p.panel.choice().own) << "what is gone cannot be chosen";
  p.panel.chooseOwnPreset("calm");
  EXPECT_TRUE(p.mistake.contains("calm"));
}

}  // namespace
}  // namespace abrazo::widgets::settings_panel_test
