// The settings panel and the sweep in the whole window, on the generated dance.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QElapsedTimer>
#include <QInputDialog>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>

#include "app/workbench/base/own_presets.hpp"
#include "core/base/atomic_file.hpp"
#include "core/evaluation/sweep/sweep.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/settings/preset_bar.hpp"
#include "widgets/settings/settings_panel.hpp"
#include "widgets/sweep/heat_map.hpp"
#include "widgets/sweep/sweep_form.hpp"
#include "widgets/sweep/sweep_panel.hpp"

namespace abrazo::app::sweep_actions_test {
namespace {

using widgets::SweepCell;

class SettingsWindow : public DemoWindow {
 protected:
  static void SetUpTestSuite() { showDemo({1280, 720}, 31); }
  void SetUp() override { ASSERT_TRUE(window().ticker().shown()) << "the demo did not start"; }

  static widgets::SettingsPanel& panel() { return window().settings(); }
  static QAction* action(const QString& text) {
    for (QAction* action : window().findChildren<QAction*>())
      if (action->text() == text) return action;
    return nullptr;
  }
};

TEST_F(SettingsWindow, AFrameSolvedUnderOtherSettingsSaysSoAndGivesThemBack) {
  FrameTicker& ticker = window().ticker();
  ticker.follow();
  const Settings before = window().document().settings();
  auto* use = panel().findChild<QPushButton*>("useFrameSettings");
  window().document().changeSetting("alpha", "0.77");
  ASSERT_TRUE(until([&] { return ticker.shown()->settings.alpha == 0.77; }));
  EXPECT_TRUE(use->parentWidget()->isHidden()) << "while following";
  ticker.seek(0.2);
  ASSERT_TRUE(until([&] { return ticker.shown()->settings == before; }));
  EXPECT_FALSE(use->parentWidget()->isHidden());
  const int steps = window().undoStack().count();
  use->click();
  EXPECT_EQ(window().document().settings(), before);
  EXPECT_EQ(window().undoStack().count(), steps + 1);
  EXPECT_TRUE(use->parentWidget()->isHidden());
  ticker.follow();
  EXPECT_TRUE(until([&] { return ticker.shown()->settings == before; }));
}

TEST_F(SettingsWindow, OwnPresetsAreKeptInTheHomeFolder) {
  window().document().changeSetting("alpha", "0.9");
  action("Save settings as preset\u2026")->trigger();
  auto* dialog = window().findChild<QInputDialog*>("presetName");
  ASSERT_NE(dialog, nullptr);
  dialog->setTextValue("mine");
  dialog->accept();
  EXPECT_TRUE(window().document().live().preset().own);
  EXPECT_EQ(window().document().live().preset().name, "mine");
  OwnPresets kept((home().path() + "/presets.json").toStdString());
  ASSERT_TRUE(kept.read());
  ASSERT_EQ(kept.all().size(), 1U);
  EXPECT_EQ(kept.all()[0].settings.alpha, 0.9);
  emit panel().presets().removeRequested("mine");
  ASSERT_TRUE(kept.read());
  EXPECT_TRUE(kept.all().empty());
  EXPECT_FALSE(window().document().live().preset().own);
}

TEST_F(SettingsWindow, ASweepFillsItsMapWhileTheLiveSolverGoesOnAndItsBestCellIsAdoptedInOneStep) {
  window().document().choosePreset("paper");
  action("Sweep two settings\u2026")->trigger();
  auto* dialog = window().findChild<QDialog*>("sweep");
  ASSERT_TRUE(dialog && dialog->isVisible());
  EXPECT_FALSE(dialog->isModal());
  auto& sweep = *dialog->findChild<widgets::SweepPanel*>();
  const auto fields = sweep.form().findChildren<QSpinBox*>();
  ASSERT_EQ(fields.size(), 2);
  for (QSpinBox* count : fields) count->setValue(2);
  action("Every third")->trigger();  // one take of the three: quicker
  auto* start = sweep.findChild<QPushButton*>("startSweep");
  ASSERT_TRUE(start->isEnabled());
  const std::uint64_t live = window().ticker().shown()->index;
  start->click();
  ASSERT_EQ(start->text(), "Cancel");
  const auto measured = [&] { return sweep.map().grid().count(SweepCell::State::Measured); };
  ASSERT_TRUE(until([&] { return measured() > 0; }));
  EXPECT_LT(measured(), 4) << "cells appear one by one";
  ASSERT_TRUE(until([&] { return start->text() == "Start"; }));
  EXPECT_EQ(measured(), 4);
  EXPECT_GT(window().ticker().shown()->index, live + 5);

  EXPECT_TRUE(sweep.findChild<QPushButton*>("exportSweep")->isEnabled());
  const int best = *sweep.map().grid().best();
  sweep.map().select(best);
  const int steps = window().undoStack().count();
  const Settings before = window().document().settings();
  sweep.findChild<QPushButton*>("adoptCell")->click();
  const auto [column, row] = sweep.map().grid().place_of(best);
  EXPECT_EQ(setting_text(window().document().settings(), "alpha"),
            sweep.map().grid().x().values[static_cast<std::size_t>(column)]);
  EXPECT_EQ(setting_text(window().document().settings(), "velocity-weight"),
            sweep.map().grid().y().values[static_cast<std::size_t>(row)]);
  EXPECT_LE(window().undoStack().count(), steps + 1);
  if (window().document().settings() != before) window().undoStack().undo();
  EXPECT_EQ(window().document().settings(), before);
  dialog->close();
}

TEST_F(SettingsWindow, ACancelledSweepKeepsWhatItHasAndCanBeStartedAgain) {
  action("Sweep two settings\u2026")->trigger();
  auto& sweep = *window().findChild<QDialog*>("sweep")->findChild<widgets::SweepPanel*>();
  for (QSpinBox* count : sweep.form().findChildren<QSpinBox*>()) count->setValue(5);
  action("Every third")->trigger();  // one take of the three: quicker
  auto* start = sweep.findChild<QPushButton*>("startSweep");
  start->click();
  const auto& grid = sweep.map().grid();
  ASSERT_TRUE(until([&] { return grid.count(SweepCell::State::Measured) > 0; }));
  start->click();
  EXPECT_EQ(start->text(), "Start");
  const int kept = grid.count(SweepCell::State::Measured);
  QTest::qWait(300);
  EXPECT_EQ(grid.count(SweepCell::State::Measured), kept) << "late cells of it do not come in";
  start->click();
  EXPECT_EQ(grid.count(SweepCell::State::Measured), 0);
  start->click();
}

TEST_F(SettingsWindow, ASweepIsWrittenAsAPageOrAsJsonByTheFilesEnding) {
  const Sweep sweep{.data = "demo",
                    .settings = *preset("paper"),
                    .x = *parse_sweep_axis("alpha=0:1:2"),
                    .y = *parse_sweep_axis("neighbours=5,10"),
                    .metric = "partner.lag_ms"};
  std::vector<Figures> points(4);
  EXPECT_TRUE(save_sweep(sweep_outcome(sweep, points), home().path() + "/none.json").contains("No cell"));
  points[1] = {{"partner.lag_ms", 60}};
  const QString page = home().path() + "/sweep.html", json = home().path() + "/sweep.json";
  EXPECT_EQ(save_sweep(sweep_outcome(sweep, points), page), "");
  EXPECT_EQ(save_sweep(sweep_outcome(sweep, points), json), "");
  EXPECT_NE(read_whole_file(page.toStdString())->find("</html>"), std::string::npos);
  EXPECT_NE(read_whole_file(json.toStdString())->find("\"abrazo_sweep\""), std::string::npos);
  EXPECT_NE(save_sweep(sweep_outcome(sweep, points), "/nowhere/at/all.html"), "");
}

}  // namespace
}  // namespace abrazo::app::sweep_actions_test
