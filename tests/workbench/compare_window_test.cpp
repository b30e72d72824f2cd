#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "app/workbench/compare/comparison_desk.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/compare/compare_panel.hpp"
#include "widgets/settings/settings_panel.hpp"

namespace abrazo::app::compare_window_test {
namespace {

using State = Playback::State;

class CompareInTheWindow : public DemoWindow {
 protected:
  static void SetUpTestSuite() {
    showWindow({1600, 1000});
    window().document().putSettings(*preset("responsive"));
    window().openDemo();
    until([] { return shown() && shown()->index > 60; });
  }
  void SetUp() override {
    ASSERT_TRUE(shown()) << "the demo did not start";
    window().ticker().follow();
    window().panels().want("compare", true);
    window().panels().panel("compare")->raise();  // what nobody sees is not solved again
    choose(*preset("responsive"));
    if (desk().frozen()) desk().setFrozen({});
    ASSERT_TRUE(until([] { return live().settings == *preset("responsive") && !desk().shown(); }));
  }

  static ComparisonDesk& desk() { return *window().findChild<ComparisonDesk*>(); }
  static widgets::ComparePanel& panel() { return *window().findChild<widgets::ComparePanel*>(); }
  static const FrameSnapshotPtr& shown() { return window().ticker().shown(); }
  static const FrameSnapshot& live() { return *window().session()->latest().newest(); }
  static void choose(const Settings& settings) { window().document().putSettings(settings); }
  static void trigger(const QString& text) {
    for (QAction* action : window().actions())
      if (action->text() == text) return action->trigger();
    FAIL() << text.toStdString();
  }
  static double lag(const RunFigures& figures) {
    return figures[static_cast<std::size_t>(RunFigure::BehindSelected)];
  }
};

TEST_F(CompareInTheWindow, AFrozenRunGoesOnBesideTheLiveOne) {
  trigger("Freeze the settings as A");
  EXPECT_EQ(desk().frozen(), *preset("responsive"));
  window().document().changeSetting("velocity-weight", "2");
  ASSERT_TRUE(until([] { return desk().shown() && desk().shown()->steps.size() > 60; }));
  const Comparison& comparison = *desk().shown();
  EXPECT_TRUE(comparison.task.follows_live);
  EXPECT_EQ(comparison.settings_a, *preset("responsive"));
  EXPECT_EQ(comparison.settings_b.velocity_weight, 2);
  EXPECT_GT(lag(comparison.figures_b), lag(comparison.figures_a));
  EXPECT_EQ(window().ticker().playback().state, State::Following);
}

TEST_F(CompareInTheWindow, AParkedCursorIsSolvedAgainWhileLiveGoesOn) {
  window().ticker().seek(live().time_s);  // older frames may have other settings
  ASSERT_TRUE(until([] { return window().ticker().playback().state == State::Parked; }));
  const double parked_s = window().ticker().playback().cursor_s;
  const std::uint64_t before = live().index;
  window().document().changeSetting("velocity-weight", "2");
  ASSERT_TRUE(until([] { return desk().shown() && desk().shown()->done; }));
  EXPECT_FALSE(desk().shown()->task.follows_live);
  EXPECT_FALSE(desk().shown()->task.a) << "A is what was recorded";
  EXPECT_EQ(desk().shown()->task.b->velocity_weight, 2);
  EXPECT_EQ(window().ticker().playback().cursor_s, parked_s);
  EXPECT_TRUE(until([before] { return live().index > before; }));
}

TEST_F(CompareInTheWindow, LiveKeepsAWhileBIsTriedAside) {
  trigger("Freeze the settings as A");
  trigger("Live keeps A");
  EXPECT_TRUE(desk().isAside());
  window().document().changeSetting("velocity-weight", "2");
  ASSERT_TRUE(
      until([] { return desk().shown() && desk().shown()->task.b && desk().shown()->steps.size() > 30; }));
  EXPECT_EQ(live().settings, *preset("responsive"));
  EXPECT_EQ(desk().shown()->settings_b.velocity_weight, 2);
  trigger("Live keeps A");
  EXPECT_TRUE(until([] { return live().settings.velocity_weight == 2; }))
      << "what was tried comes when the live solver is let go";
}

/// They stayed, and were those of the session's frame at the same time.
TEST_F(CompareInTheWindow, ATakeThatIsAnnotatedHasNoGhostsOfTheSession) {
  window().ticker().seek(live().time_s);
  ASSERT_TRUE(until([] { return window().ticker().playback().state == State::Parked; }));
  const double parked_s = window().ticker().playback().cursor_s;
  window().document().changeSetting("velocity-weight", "2");
  ASSERT_TRUE(until([] { return desk().shown() && desk().shown()->done; }));
  ASSERT_TRUE(until([] { return window().scene().showsComparison(); }));
  const auto& takes = window().session()->material().library->takes();
  window().requestSubject(QString::fromStdString(takes.front().name));
  window().ticker().seek(parked_s);
  EXPECT_TRUE(until([] { return !window().scene().showsComparison(); }));
  window().requestSubject("");
  EXPECT_TRUE(until([] { return window().scene().showsComparison(); })) << "they are there again";
}

TEST_F(CompareInTheWindow, SwapAndAdoptAreOneStepOfUndoEach) {
  trigger("Freeze the settings as A");
  window().document().changeSetting("velocity-weight", "2");
  const int steps = window().undoStack().index();
  trigger("Swap A and B");
  EXPECT_EQ(desk().frozen()->velocity_weight, 2);
  EXPECT_EQ(window().document().settings(), *preset("responsive"));
  EXPECT_EQ(window().undoStack().index(), steps + 1);
  window().undoStack().undo();
  EXPECT_EQ(desk().frozen(), *preset("responsive"));
  EXPECT_EQ(window().document().settings().velocity_weight, 2);
  trigger("Adopt the settings of A");
  EXPECT_EQ(window().document().settings(), *preset("responsive"));
  window().undoStack().undo();
  EXPECT_EQ(window().document().settings().velocity_weight, 2);
}

TEST_F(CompareInTheWindow, ACancelledWhatIfIsNotTakenUpAgainByItself) {
  window().ticker().seek(shown()->time_s - 0.2);
  panel().setSpan(WhatIfSpan::TenSeconds);
  emit panel().spanRequested(WhatIfSpan::TenSeconds);
  window().document().changeSetting("morph-steps", "20");
  ASSERT_TRUE(until([] { return desk().hasAsked(); }));
  desk().cancel();
  QTest::qWait(100);
  const auto solved = [] { return desk().shown() ? desk().shown()->steps.size() : 0; };
  const std::size_t at_cancel = solved();
  QTest::qWait(600);
  EXPECT_EQ(solved(), at_cancel) << "what is there stays, and nothing is added";
  panel().setSpan(WhatIfSpan::TwoSeconds);
  emit panel().spanRequested(WhatIfSpan::TwoSeconds);
  EXPECT_TRUE(until([] { return desk().shown() && desk().shown()->done; }));
}

TEST_F(CompareInTheWindow, AIsOfItsSessionAlone) {
  trigger("Freeze the settings as A");
  window().document().changeSetting("velocity-weight", "2");
  trigger("Swap A and B");
  trigger("Live keeps A");
  ASSERT_TRUE(desk().frozen() && desk().isAside());
  ASSERT_TRUE(until([] { return desk().shown() != nullptr; }));
  QSignalSpy began(&window().document(), &Document::began);  // the next session may lie at the same address
  window().openDemo();
  ASSERT_TRUE(until([&] { return began.count() == 1 && shown() && shown()->index > 60; }));
  EXPECT_FALSE(desk().frozen());
  EXPECT_FALSE(desk().isAside());
  EXPECT_FALSE(desk().shown());
  EXPECT_FALSE(action("Live keeps A")->isChecked());
  EXPECT_FALSE(action("Swap A and B")->isEnabled());
  window().document().changeSetting("velocity-weight", "1.5");
  EXPECT_TRUE(until([] { return live().settings.velocity_weight == 1.5; })) << "live is not held any longer";
  window().undoStack().undo();
  window().undoStack().undo();
  EXPECT_FALSE(desk().frozen()) << "the swap was of the session before";
  trigger("Freeze the settings as A");
  window().document().changeSetting("velocity-weight", "1.2");
  EXPECT_TRUE(until([] { return desk().shown() && desk().shown()->steps.size() > 10; })) << "it runs anew";
}

}  // namespace
}  // namespace abrazo::app::compare_window_test
