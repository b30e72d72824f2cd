// Another theme in an open window: what changes, in how many turns, and what is seen of it.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDockWidget>
#include <QProxyStyle>
#include <QTest>
#include <QThread>
#include <algorithm>
#include <array>

#include "app/workbench/shell/panel_area.hpp"
#include "tests/widgets/pictures.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/settings/settings_panel.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app::colours_test {
namespace {

/// A window with everything in it and nothing open.
class Colours : public DemoWindow {
 protected:
  static void SetUpTestSuite() { showWindow({1600, 1000}); }
  void SetUp() override {
    window().resize(1600, 1000);
    window().resetLayout();
    window().activateWindow();
    QTest::qWait(20);
  }
};

/// Every widget was laid out anew, which stopped the window for a second on a busy machine.
TEST_F(Colours, OtherColoursLayNothingOutAnewAndComeBack) {
  struct Counts : QObject {
    int styles = 0;
    bool eventFilter(QObject* watched, QEvent* event) override {
      styles += event->type() == QEvent::StyleChange;
      return QObject::eventFilter(watched, event);
    }
  };
  const auto pictures = [] {
    EXPECT_TRUE(until([] { return !widgets::is_applying_theme(); }));
    QTest::qWait(50);
    return std::array{window().settings().grab().toImage(), window().candidates().grab().toImage(),
                      window().timeline().grab().toImage()};
  };
  const auto dark = pictures();
  Counts counts;
  const auto all = window().findChildren<QWidget*>();
  for (QWidget* each : all) each->installEventFilter(&counts);
  window().setTheme(widgets::Theme::Light);
  const auto light = pictures();
  window().setTheme(widgets::Theme::Dark);
  EXPECT_LT(10 * counts.styles, all.size()) << "only of widgets with a sheet of their own";
  for (std::size_t p = 0; p < dark.size(); ++p) {
    EXPECT_GT(test::difference(dark[p], light[p]), 0.3) << p;
    EXPECT_EQ(pictures()[p], dark[p]) << p;
  }
}

/// All widgets at once would hold the window up; it is painted again when all of them have the colours.
TEST_F(Colours, AChangeOfColoursIsNotSeenInParts) {
  ASSERT_TRUE(until([] { return !widgets::is_applying_theme(); }));
  window().setTheme(widgets::Theme::Light);
  EXPECT_TRUE(widgets::is_applying_theme());
  EXPECT_FALSE(window().updatesEnabled());
  window().setTheme(widgets::Theme::Dark);  // before the first one is complete
  EXPECT_TRUE(until([] { return !widgets::is_applying_theme(); }));
  EXPECT_TRUE(window().updatesEnabled());
}

/// Takes longer for each widget than a turn of the event loop may, and counts those of one turn.
class SlowColours : public QProxyStyle {
 public:
  void polish(QWidget* widget) override {
    QProxyStyle::polish(widget);
    QThread::msleep(25);
    ++total;
    most_at_once = std::max(most_at_once, ++m_at_once);
    QMetaObject::invokeMethod(
        this, [this] { m_at_once = 0; }, Qt::QueuedConnection);
  }
  using QProxyStyle::polish;
  int total = 0, most_at_once = 0;

 private:
  int m_at_once = 0;
};

TEST_F(Colours, TheWindowAnswersWhileItsColoursChange) {
  SlowColours slow;
  QWidget other;
  for (int i = 0; i < 4; ++i) (new QWidget(&other))->setStyle(&slow);
  other.show();
  ASSERT_TRUE(until([] { return !widgets::is_applying_theme(); }));
  turn();
  window().setTheme(widgets::Theme::Light);
  slow.total = slow.most_at_once = 0;
  EXPECT_TRUE(until([] { return !widgets::is_applying_theme(); }));
  EXPECT_EQ(slow.total, 4);
  EXPECT_LT(slow.most_at_once, slow.total);
  window().setTheme(widgets::Theme::Dark);
  EXPECT_TRUE(until([] { return !widgets::is_applying_theme(); }));
}

/// The scene asks for a picture with every frame, and the request may come while nothing is painted. The
/// window was never painted again.
TEST_F(Colours, WhatIsToBePaintedWhenTheColoursChangeDoesNotStopTheWindow) {
  struct Painted : QObject {
    int times = 0;
    bool eventFilter(QObject*, QEvent* event) override {
      times += event->type() == QEvent::Paint;
      return false;
    }
  };
  ASSERT_TRUE(until([] { return !widgets::is_applying_theme(); }));
  QTest::qWait(50);
  SlowColours slow;
  QWidget other;  // has the colours change for longer than a request takes
  for (int i = 0; i < 4; ++i) (new QWidget(&other))->setStyle(&slow);
  other.show();
  turn();
  widgets::TimelineView& timeline = window().timeline();
  Painted painted;
  timeline.installEventFilter(&painted);
  for (const auto theme : {widgets::Theme::Light, widgets::Theme::Dark}) {
    timeline.update();
    window().setTheme(theme);
    ASSERT_TRUE(until([] { return !widgets::is_applying_theme(); }));
    painted.times = 0;
    timeline.update();
    EXPECT_TRUE(until([&painted] { return painted.times > 0; }));
  }
}

/// Without it Qt draws the list as a menu, whose chosen entry is white on white here.
TEST_F(Colours, ListsOfFieldsAreListsAndNotMenus) {
  QComboBox field;
  field.addItems({"one", "two"});
  field.show();
  EXPECT_EQ(field.style()->styleHint(QStyle::SH_ComboBox_Popup, nullptr, &field), 0);
}

/// What is hidden is not polished for the new colours until it is shown.
TEST_F(Colours, WhatWasHiddenDuringAChangeOfColoursHasThemWhenItIsShown) {
  widgets::SettingsPanel& settings = window().settings();
  QDockWidget& panel = *window().panels().panel("settings");
  const auto picture = [&settings] {
    EXPECT_TRUE(until([] { return !widgets::is_applying_theme(); }));
    QTest::qWait(50);
    return settings.grab().toImage();
  };
  window().setTheme(widgets::Theme::Light);
  const QImage light = picture();
  window().setTheme(widgets::Theme::Dark);
  picture();
  panel.hide();
  window().setTheme(widgets::Theme::Light);
  panel.show();
  EXPECT_EQ(picture(), light);
  window().setTheme(widgets::Theme::Dark);
}

}  // namespace
}  // namespace abrazo::app::colours_test
