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

#include "core/session/edit/live_project.hpp"
#include "tests/widgets/pictures.hpp"
#include "widgets/common/value_slider.hpp"
#include "widgets/settings/preset_bar.hpp"
#include "widgets/settings/setting_row.hpp"
#include "widgets/settings/toggle.hpp"

namespace abrazo::widgets::settings_panel_test {
namespace {

/// The panel with a project that answers what it asks for, as the window does.
struct Panel {
  SettingsPanel panel;
  LiveProject live;
  std::vector<ProjectEdit> steps;
  std::vector<Settings> asked;
  QString mistake;

  Panel() {
    QObject::connect(&panel, &SettingsPanel::entryRequested,
                     [this](const QString& key, const QString& text, int gesture) {
                       answer(live.with_setting(key.toStdString(), text.toStdString()), key, gesture);
                     });
    QObject::connect(&panel, &SettingsPanel::presetRequested, [this](const QString& name, bool own) {
      answer(live.with_preset(name.toStdString(), own), {}, 0);
    });
    QObject::connect(&panel, &SettingsPanel::settingsRequested,
                     [this](const Settings& settings) { answer(live.with_settings(settings), {}, 0); });
  }
  ~Panel() { panel.disconnect(); }  // a field that goes with the focus and other text asks once more
  void answer(const Result<ChosenSettings>& next, const QString& key, int gesture) {
    if (!next) {
      mistake = QString::fromStdString(next.error().text());
      return show();
    }
    asked.push_back(next->settings);
    auto edit = live.edit(*next, "edit");
    if (!edit) return show();
    edit->key = key.toStdString();
    edit->gesture = gesture;
    live.put(edit->after);
    if (steps.empty() || !steps.back().absorb(*edit)) steps.push_back(*edit);
    if (steps.back().is_nothing()) steps.pop_back();
    show();
  }
  void undo() {
    live.put(steps.back().before);
    steps.pop_back();
    show();
  }
  void show() { panel.showSettings(live.project().settings, live.preset()); }
  void enter(const QString& key, const QString& text) { emit panel.entryRequested(key, text, 0); }
  const Settings& settings() const { return live.project().settings; }
};

TEST(SettingsPanel, AnEntryThatIsRefusedIsTakenBack) {
  Panel p;
  p.enter("alpha", "much");
  EXPECT_EQ(p.settings(), preset("paper").value());
  EXPECT_TRUE(p.asked.empty());
  EXPECT_TRUE(p.mistake.contains("alpha")) << p.mistake.toStdString();
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
  EXPECT_EQ(p.steps.size(), 1U);
  EXPECT_GE(p.asked.size(), 4u) << "every move goes to the solver";
  EXPECT_GT(p.settings().alpha, 2);
  p.undo();
  EXPECT_EQ(p.settings(), *preset("paper"));
  drag(p.slider("alpha"), {150});
  drag(p.slider("alpha"), {180});
  EXPECT_EQ(p.steps.size(), 2U) << "two drags";
}

/// It stayed, and was refused again whenever the field lost the focus.
TEST(SettingsPanel, ABodyThatIsRefusedIsRefusedOnceAndTakenBack) {
  ShownPanel p;
  p.show();
  QApplication::setActiveWindow(&p.panel);  // without the focus a field completes nothing, and loses nothing
  QLineEdit& body = p.field("active-body");
  body.setFocus();
  ASSERT_TRUE(body.hasFocus());
  body.selectAll();
  QTest::keyClicks(&body, "scale:9");
  QTest::keyClick(&body, Qt::Key_Return);
  EXPECT_TRUE(p.mistake.contains("scale")) << p.mistake.toStdString();
  EXPECT_EQ(body.text(), "library");
  p.mistake.clear();
  body.clearFocus();
  EXPECT_EQ(p.mistake, "");
  body.setFocus();
  body.selectAll();
  QTest::keyClicks(&body, "scale:0.8");
  QTest::keyClick(&body, Qt::Key_Return);
  EXPECT_EQ(p.settings().active_body.scale, 0.8) << "not what the list has that begins like it";
  EXPECT_EQ(p.steps.size(), 1U);
}

TEST(SettingsPanel, TheFileOfABodyCanBeChosen) {
  ShownPanel p;
  QSignalSpy asked(&p.panel, &SettingsPanel::fileRequested);
  for (const char* key : {"active-body", "passive-body"}) {
    auto* choose = p.row(key).findChild<QToolButton*>();
    ASSERT_TRUE(choose) << key;
    choose->click();
    ASSERT_EQ(asked.count(), 1);
    EXPECT_EQ(asked.takeFirst().front().toString(), key);
  }
}

TEST(SettingsPanel, ADragThatEndsWhereItBeganIsNoStep) {
  ShownPanel p;
  const int home = static_cast<int>(p.slider("alpha").handleX());
  drag(p.slider("alpha"), {200, home});
  EXPECT_EQ(p.steps.size(), 0U);
  EXPECT_EQ(p.settings(), *preset("paper"));
}

TEST(SettingsPanel, TakingTheHandleDoesNotMoveIt) {
  ShownPanel p;
  const int home = static_cast<int>(p.slider("velocity-weight").handleX());
  QTest::mouseClick(&p.slider("velocity-weight"), Qt::LeftButton, {}, {home + 3, 8});
  EXPECT_TRUE(p.asked.empty());
}

TEST(SettingsPanel, ADoubleClickGoesBackToTheDefaultInOneStep) {
  ShownPanel p;
  p.enter("alpha", "1.5");
  QTest::mousePress(&p.slider("alpha"), Qt::LeftButton, {}, {250, 8});
  QTest::mouseRelease(&p.slider("alpha"), Qt::LeftButton, {}, {250, 8});
  QTest::mouseDClick(&p.slider("alpha"), Qt::LeftButton, {}, {250, 8});
  EXPECT_EQ(p.settings().alpha, 0.5);
  p.undo();
  EXPECT_EQ(p.settings().alpha, 1.5);
}

TEST(SettingsPanel, ArrowKeysStepAndAHeldKeyIsOneStepOfUndo) {
  ShownPanel p;
  ValueSlider& slider = p.slider("neighbours");
  slider.setFocus();
  QTest::keyClick(&slider, Qt::Key_Right);
  EXPECT_EQ(p.settings().neighbours, 11);
  QTest::keyClick(&slider, Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_EQ(p.settings().neighbours, 1);
  EXPECT_EQ(p.steps.size(), 2U);
  QTest::keyPress(&slider, Qt::Key_Up);
  for (int repeat = 0; repeat < 3; ++repeat) {
    QKeyEvent held(QEvent::KeyPress, Qt::Key_Up, {}, {}, true);
    QApplication::sendEvent(&slider, &held);
  }
  EXPECT_EQ(p.settings().neighbours, 5);
  EXPECT_EQ(p.steps.size(), 3U);
  QTest::keyClick(&slider, Qt::Key_Backspace);
  EXPECT_EQ(p.settings().neighbours, 10);
}

TEST(SettingsPanel, AValueCanBeTypedWithOrWithoutItsUnit) {
  ShownPanel p;
  QLineEdit& field = p.field("foot-lock-speed");
  QTest::mouseClick(&field, Qt::LeftButton);
  QTest::keyClicks(&field, "0.25 m/s");
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(p.settings().foot_lock_speed, 0.25);
  EXPECT_EQ(field.text(), "0.25 m/s");
}

TEST(SettingsPanel, SwitchesAndListsWorkByKeyAndAreSteps) {
  ShownPanel p;
  Toggle& locks = *p.row("foot-locks").findChild<Toggle*>();
  locks.setFocus();
  QTest::keyClick(&locks, Qt::Key_Space);
  EXPECT_FALSE(p.settings().foot_locks);
  QTest::keyClick(&locks, Qt::Key_Space);
  EXPECT_TRUE(p.settings().foot_locks);
  QComboBox& form = *p.row("velocity-form").findChild<QComboBox*>();
  QTest::keyClick(&form, Qt::Key_Down);
  EXPECT_EQ(p.settings().velocity_form, VelocityForm::Predicted);
  EXPECT_EQ(p.steps.size(), 3U);
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

TEST(SettingsPanel, ASettingWithoutEffectSaysSoWhereItStands) {
  ShownPanel p;
  p.panel.resize(406, 900);  // as wide as usual
  QTest::qWait(1);
  int without = 0;
  for (const char* method : {"paper", "intent"}) {
    p.enter("selection", method);
    for (const SettingInfo& info : all_settings()) {
      const bool has_effect = applies(p.settings(), info.key);
      const QString title = p.title(std::string(info.key).c_str());
      EXPECT_EQ(title.contains("no effect now"), !has_effect) << title.toStdString();
      without += has_effect ? 0 : 1;
    }
  }
  EXPECT_GT(without, 1);
}

/// Titles that say that they have no effect pushed their values out of a narrow column.
TEST(SettingsPanel, ANarrowColumnShortensTitlesAndCutsOffNoValue) {
  ShownPanel p;
  for (const int width : {340, 300})
    for (const char* name : {"paper", "responsive"}) {
      p.panel.resize(width, 500);
      emit p.panel.presetRequested(name, false);
      QTest::qWait(1);
      for (const SettingRow* row : p.panel.findChildren<SettingRow*>()) {
        const auto* title = row->findChild<QLabel*>();
        const std::string words = std::string(name) + ": " + title->text().toStdString();
        EXPECT_LE(row->width(), width) << words;
        EXPECT_GE(row->width(), row->minimumSizeHint().width()) << words;
        EXPECT_LE(title->sizeHint().width(), title->width()) << words;
        EXPECT_EQ(title->text().contains("no effect"), !applies(p.settings(), row->info().key)) << words;
      }
    }
  EXPECT_TRUE(p.title("switch-margin").contains("switch margin")) << p.title("switch-margin").toStdString();
}

TEST(SettingsPanel, AStarMarksThePresetAndTheRowThatWereChanged) {
  ShownPanel p;
  EXPECT_FALSE(p.title("alpha").contains("*"));
  p.enter("alpha", "0.7");
  EXPECT_TRUE(p.title("alpha").contains("*"));
  EXPECT_FALSE(p.title("morph-steps").contains("*"));
  EXPECT_EQ(p.panel.presets().findChildren<QToolButton*>().front()->text(), "paper *");
  emit p.panel.presetRequested("responsive", false);
  EXPECT_EQ(p.panel.presets().findChildren<QToolButton*>().front()->text(), "paper");
  p.undo();
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
  EXPECT_EQ(p.settings().selection, SelectionMethod::Intent);
  EXPECT_TRUE(p.slider("switch-margin").isEnabled());
  EXPECT_FALSE(p.row("switch-margin").toolTip().contains("Only with"));
  EXPECT_FALSE(p.slider("continuations").isEnabled());
  EXPECT_TRUE(p.row("continuations").toolTip().contains("Only with the method paper"));
  EXPECT_TRUE(p.slider("alpha").isEnabled()) << "both have it";
  p.undo();
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
  EXPECT_EQ(p.settings(), of_frame);
  EXPECT_FALSE(use->isVisible());
  EXPECT_EQ(p.steps.size(), 1U);
  p.undo();
  EXPECT_EQ(p.settings(), *preset("paper"));
  EXPECT_TRUE(use->isVisible());
  p.panel.showFrameSettings(std::nullopt);
  EXPECT_FALSE(use->isVisible());
}

TEST(SettingsPanel, OwnPresetsCanBeChosenAndAreDefaultsThen) {
  ShownPanel p;
  Settings calm = *preset("paper");
  calm.alpha = 2;
  p.panel.presets().setOwn({{"calm", calm}});
  p.live.put(std::vector<OwnPreset>{{"calm", calm}});
  emit p.panel.presetRequested("calm", true);
  EXPECT_EQ(p.settings(), calm);
  EXPECT_TRUE(p.live.preset().own);
  p.enter("alpha", "1");
  EXPECT_TRUE(p.title("alpha").contains("*"));
  QMenu menu;
  p.panel.presets().fillMenu(menu);
  QStringList offered;
  for (const QAction* action : menu.actions()) offered << action->text();
  EXPECT_TRUE(offered.contains("calm"));
  EXPECT_TRUE(offered.join("|").contains("Rename")) << offered.join("|").toStdString();
  p.panel.presets().setOwn({});
  p.live.put(std::vector<OwnPreset>{});
  EXPECT_FALSE(p.live.preset().own) << "what is gone cannot be chosen";
  emit p.panel.presetRequested("calm", true);
  EXPECT_TRUE(p.mistake.contains("calm"));
}

}  // namespace
}  // namespace abrazo::widgets::settings_panel_test
