#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QFile>
#include <QGuiApplication>
#include <QMenu>
#include <QMenuBar>
#include <QMouseEvent>
#include <QScreen>
#include <QSplitter>
#include <QTabBar>
#include <QTest>
#include <numbers>
#include <random>

#include "app/workbench/project/remembered_view.hpp"
#include "app/workbench/shell/dock_state.hpp"
#include "app/workbench/shell/layouts.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "app/workbench/shell/window_place.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/candidates/candidate_list.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/settings/setting_row.hpp"
#include "widgets/settings/settings_panel.hpp"
#include "widgets/takes/take_panel.hpp"

namespace abrazo::app::layout_test {
namespace {

/// A window with everything in it and nothing open: enough for what concerns its panels.
class Layout : public DemoWindow {
 protected:
  static void SetUpTestSuite() { showWindow({1600, 1000}); }
  void SetUp() override {
    window().resize(1600, 1000);
    window().resetLayout();
    window().activateWindow();
    QTest::qWait(20);
  }

  static PanelArea& area() { return window().panels(); }
  static QDockWidget& panel(const char* id) { return *area().panel(id); }
  static Layouts& layouts() { return *window().findChild<Layouts*>(); }
  static Qt::DockWidgetArea side(const char* id) { return area().dockWidgetArea(&panel(id)); }
  static void write(const QString& path, const QByteArray& content) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(content);
  }
};

TEST_F(Layout, PlotsAreBelowTheSceneAndTheTimelineIsBelowEverything) {
  const QRect plots = panel("plots").geometry();
  EXPECT_GE(plots.left(), panel("scene").geometry().right());
  EXPECT_LE(plots.right(), panel("candidates").geometry().left());
  EXPECT_EQ(area().width(), window().width());
  EXPECT_GT(panel("settings").geometry().top(), panel("candidates").geometry().top());
  EXPECT_GT(panel("library").geometry().top(), panel("scene").geometry().top());
}

TEST_F(Layout, PanelsAreFloatedMovedAndClosedAndTheSceneKeepsItsParent) {
  const QWidget* parent = window().scene().parentWidget();
  panel("plots").setFloating(true);
  panel("settings").setFloating(true);
  area().addDockWidget(Qt::LeftDockWidgetArea, &panel("candidates"));
  area().tabifyDockWidget(&panel("scene"), &panel("library"));
  area().want("plots", false);
  layouts().choose("Live");
  layouts().choose("Inspect");
  window().resize(700, 420);
  QTest::qWait(20);
  EXPECT_EQ(window().scene().parentWidget(), parent);
}

/// Four panels in one place, as wide as a column may be: "Cand…" names none of them.
TEST_F(Layout, TabsOfPanelsHaveTheirWholeNamesInANarrowColumn) {
  for (const char* id : {"settings", "plots", "library"})
    area().tabifyDockWidget(&panel("candidates"), &panel(id));
  QTest::qWait(50);
  int tabs = 0;
  for (const QTabBar* bar : area().findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly)) {
    EXPECT_EQ(bar->elideMode(), Qt::ElideNone);
    tabs += bar->count();
  }
  EXPECT_GE(tabs, 4);
  window().resetLayout();
}

/// A window whose layout asks for another layout never rests.
TEST_F(Layout, IsAtRestWhenNothingChanges) {
  class Counter : public QObject {
   public:
    bool eventFilter(QObject*, QEvent* event) override {
      requests += event->type() == QEvent::LayoutRequest;
      return false;
    }
    int requests = 0;
  } counter;
  area().tabifyDockWidget(&panel("candidates"), &panel("settings"));
  QTest::qWait(50);
  area().installEventFilter(&counter);
  constexpr int turns = 500;
  for (int turn = 0; turn < turns; ++turn) QApplication::processEvents();
  EXPECT_LT(counter.requests, turns / 10);
  window().resetLayout();
}

/// A small window hides them all; the first of a place was in front afterwards.
/// In a small window there is no room for them until they are asked for.
TEST_F(Layout, APlotThatIsAddedIsSeen) {
  window().resize(1280, 720);
  QTest::qWait(50);
  ASSERT_FALSE(panel("plots").isVisible()) << "the case needs a window without them";
  for (QAction* action : window().findChildren<QAction*>())
    if (action->text() == "Add plot…") action->trigger();
  EXPECT_TRUE(until([] { return panel("plots").isVisible(); }));
  EXPECT_GT(panel("plots").height(), 60);
}

TEST_F(Layout, ThePanelThatWasInFrontIsThereAgainWhenThereIsRoomAgain) {
  window().resize(1600, 1000);
  QTest::qWait(50);
  area().tabifyDockWidget(&panel("candidates"), &panel("settings"));
  panel("settings").raise();
  ASSERT_TRUE(until([] { return !panel("settings").visibleRegion().isEmpty(); }));
  window().resize(640, 400);
  ASSERT_TRUE(until([] { return panel("settings").isHidden(); }));
  window().resize(1600, 1000);
  EXPECT_TRUE(until([] { return !panel("settings").visibleRegion().isEmpty(); }));
  EXPECT_TRUE(panel("candidates").visibleRegion().isEmpty());
  window().resetLayout();
}

/// A white line was below the tabs of candidates and comparison.
TEST_F(Layout, TabsOfPanelsHaveNoLineBelow) {
  area().tabifyDockWidget(&panel("scene"), &panel("library"));
  area().tabifyDockWidget(&panel("plots"), &panel("settings"));
  QTest::qWait(20);
  int bars = 0;
  for (const QTabBar* tabs : area().findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly)) {
    EXPECT_FALSE(tabs->drawBase()) << tabs->tabText(0).toStdString();
    EXPECT_FALSE(tabs->accessibleName().isEmpty());
    ++bars;
  }
  EXPECT_GE(bars, 2);
}

TEST_F(Layout, AnArrangementComesBackAsItWasSaved) {
  area().addDockWidget(Qt::LeftDockWidgetArea, &panel("settings"));
  area().want("plots", false);
  panel("library").setFloating(true);
  ASSERT_TRUE(layouts().save("my / own"));
  EXPECT_EQ(layouts().own(), QStringList{"my / own"});
  window().resetLayout();
  EXPECT_EQ(side("settings"), Qt::RightDockWidgetArea);
  EXPECT_TRUE(panel("plots").isVisible());
  ASSERT_TRUE(layouts().choose("my / own"));
  EXPECT_EQ(side("settings"), Qt::LeftDockWidgetArea);
  EXPECT_FALSE(panel("plots").isVisible());
  EXPECT_TRUE(panel("library").isFloating());
  EXPECT_TRUE(layouts().remove("my / own"));
  EXPECT_TRUE(layouts().own().isEmpty());
}

TEST_F(Layout, TheLastArrangementIsRestoredAtTheNextStart) {
  area().want("library", false);
  window().close();  // saves
  window().resetLayout();
  window().show();
  EXPECT_TRUE(panel("library").isVisible());
  EXPECT_TRUE(layouts().restoreLast());
  EXPECT_FALSE(panel("library").isVisible());
}

TEST_F(Layout, ABrokenOrForeignArrangementIsToldAndTheUsualOneIsShown) {
  const std::vector<std::pair<QByteArray, QString>> cases = {
      {"no layout", "is not a window layout"},
      {"{\"abrazo_layout\": 99}", "of another version"},
      {"{\"abrazo_layout\": 1, \"docks\": \"AAAA\", \"shown\": []}", "does not fit"}};
  for (const auto& [content, message] : cases) {
    area().want("plots", false);
    write(remembered().folder() + "/layout-inspect.json", content);
    EXPECT_FALSE(layouts().restoreLast());
    EXPECT_TRUE(window().messages().text().contains(message)) << window().messages().text().toStdString();
    EXPECT_TRUE(panel("plots").isVisible());
  }
}

/// A few bytes of the text are others, gone, or there twice.
QByteArray changed(QByteArray bytes, std::mt19937& random) {
  for (auto changes = 1 + random() % 6; changes > 0 && !bytes.isEmpty(); --changes) {
    const int at = static_cast<int>(random() % static_cast<unsigned>(bytes.size()));
    const int length = static_cast<int>(random() % 9);
    switch (random() % 5) {
      case 0:
        bytes[at] = static_cast<char>(random());
        break;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
        break;
      case 2:
        bytes.remove(at, length);
        break;
      case 3:
        bytes.insert(at, bytes.mid(at, length));
        break;
      default:
        bytes.replace(at, 4, QByteArray(4, random() % 2 ? '\xff' : '\x7f'));
        break;
    }
  }
  return bytes;
}

TEST_F(Layout, EveryArrangementThatTheWindowWritesIsOne) {
  const auto expect_one = [](const char* what) {
    EXPECT_TRUE(is_dock_state(window().layoutOfPanels().docks, layout_version)) << what;
  };
  expect_one("usual");
  panel("settings").setFloating(true);
  expect_one("floating");
  area().tabifyDockWidget(&panel("scene"), &panel("library"));
  expect_one("tabs");
  area().splitDockWidget(&panel("plots"), &panel("candidates"), Qt::Horizontal);
  expect_one("nested");
  for (const QDockWidget* each : area().panels()) area().want(each->objectName(), false);
  expect_one("all hidden");
  window().resize(640, 400);
  QTest::qWait(20);
  expect_one("small");
}

/// Qt would write to the docks with this number.
TEST_F(Layout, ADockAreaThatThereIsNotIsRefused) {
  WindowLayout layout = window().layoutOfPanels();
  ASSERT_EQ(layout.docks[8], '\xfd') << "the mark of dock areas; then how many, then the number of the first";
  layout.docks.replace(13, 4, "\x40\x00\x00\x00", 4);
  EXPECT_FALSE(window().setLayoutOfPanels(layout));
  layout = window().layoutOfPanels();
  EXPECT_FALSE(is_dock_state(layout.docks, layout_version + 1));
  EXPECT_FALSE(is_dock_state(layout.docks + "x", layout_version));
  EXPECT_FALSE(is_dock_state(layout.docks.chopped(1), layout_version));
  EXPECT_FALSE(is_dock_state({}, layout_version));
}

TEST_F(Layout, WhateverAFileSaysOfThePanelsTheWindowStaysUsable) {
  const auto shown = [] {
    QStringList names;
    for (const QDockWidget* each : area().panels())
      if (each->isVisible()) names << each->objectName();
    return names;
  };
  const QStringList usual = shown();
  std::mt19937 random(20261122);
  panel("settings").setFloating(true);
  const WindowLayout layout = window().layoutOfPanels();
  int taken = 0;
  for (int round = 0; round < 200; ++round) {
    WindowLayout other = layout;
    if (round % 2 == 0)
      other.docks = changed(layout.docks, random);
    else if (const auto read = parse_layout(changed(text_of(layout), random), "a.json"))
      other = *read;
    const QSize before = window().size();
    taken += window().setLayoutOfPanels(other);
    QTest::qWait(0);
    EXPECT_EQ(window().size(), before) << round;
    for (const QDockWidget* each : area().panels())
      EXPECT_TRUE(each->isFloating() ||
                  area().dockWidgetArea(const_cast<QDockWidget*>(each)) != Qt::NoDockWidgetArea)
          << round << each->objectName().toStdString();
  }
  EXPECT_GT(taken, 20) << "the files were too odd";
  window().resetLayout();
  QTest::qWait(20);
  EXPECT_EQ(shown(), usual);
}

TEST_F(Layout, APanelThatALayoutDoesNotKnowStandsInItsUsualPlace) {
  WindowLayout older = window().layoutOfPanels();
  older.known.removeAll("plots");
  older.shown.removeAll("plots");
  ASSERT_TRUE(window().setLayoutOfPanels(older));
  EXPECT_TRUE(panel("plots").isVisible());
  EXPECT_EQ(side("plots"), Qt::BottomDockWidgetArea);
}

TEST_F(Layout, EachTaskHasItsPanelsAndKeepsWhatAPersonChanged) {
  layouts().choose("Annotate");
  EXPECT_TRUE(panel("annotation").isVisible());
  EXPECT_FALSE(area().isWanted("plots"));
  EXPECT_FALSE(area().isWanted("settings"));
  area().want("plots", true);
  layouts().choose("Live");
  EXPECT_TRUE(area().isWanted("connection"));
  EXPECT_TRUE(area().isWanted("recording"));
  EXPECT_FALSE(area().isWanted("candidates"));
  layouts().choose("Annotate");
  EXPECT_TRUE(area().isWanted("plots")) << "as it was left";
  layouts().reset();
  EXPECT_FALSE(area().isWanted("plots"));
  layouts().choose("Inspect");
  for (const char* id : {"scene", "candidates", "settings", "plots"}) EXPECT_TRUE(area().isWanted(id)) << id;
  EXPECT_FALSE(layouts().save("Inspect")) << "a built-in name cannot be taken";
}

TEST_F(Layout, AStreamAndATakeBringTheirTaskAndATakeThatIsLeftGivesItBack) {
  layouts().showTake(true);
  EXPECT_EQ(layouts().task(), "Inspect") << "nobody is there whose work could be followed";
  layouts().setFollowsWork(true);
  layouts().showTake(true);
  EXPECT_EQ(layouts().task(), "Annotate");
  layouts().showTake(false);
  EXPECT_EQ(layouts().task(), "Inspect");
  layouts().beginLive();
  EXPECT_EQ(layouts().task(), "Live");
  layouts().setFollowsWork(false);
  layouts().choose("Inspect");
}

TEST_F(Layout, ASmallWindowHidesPanelsWithoutForgettingThem) {
  window().resize(640, 400);
  QTest::qWait(20);
  for (const char* id : {"scene", "library", "candidates", "settings", "plots"}) {
    EXPECT_FALSE(panel(id).isVisible()) << id;
    EXPECT_TRUE(area().isWanted(id)) << id;
  }
  QTest::keyClick(&window(), Qt::Key_F8);
  EXPECT_TRUE(panel("scene").isVisible()) << "asked for, so it is shown whatever the size";
  QTest::keyClick(&window(), Qt::Key_F8);
  EXPECT_FALSE(panel("scene").isVisible());
  window().resetLayout();
  window().resize(1600, 1000);
  QTest::qWait(20);
  EXPECT_TRUE(panel("scene").isVisible());
  EXPECT_TRUE(panel("plots").isVisible());
}

/// Shown for a look and hidden again in a small window, they stayed hidden in a large one, and the other way
/// round.
TEST_F(Layout, PanelsThatWereShownAndHiddenAgainFollowTheSizeOfTheWindow) {
  window().resize(640, 400);
  QTest::qWait(20);
  for (const Qt::Key key : {Qt::Key_F8, Qt::Key_F8, Qt::Key_F9, Qt::Key_F9}) QTest::keyClick(&window(), key);
  ASSERT_FALSE(panel("scene").isVisible());
  ASSERT_FALSE(panel("settings").isVisible());
  window().resize(1600, 1000);
  QTest::qWait(20);
  EXPECT_TRUE(panel("scene").isVisible());
  EXPECT_TRUE(panel("settings").isVisible());
  for (const Qt::Key key : {Qt::Key_F8, Qt::Key_F8}) QTest::keyClick(&window(), key);
  ASSERT_TRUE(panel("scene").isVisible());
  window().resize(640, 400);
  QTest::qWait(20);
  EXPECT_FALSE(panel("scene").isVisible());
  window().resize(1600, 1000);
  QTest::qWait(20);
  QTest::keyClick(&window(), Qt::Key_F8);
  window().resize(640, 400);
  QTest::qWait(20);
  window().resize(1600, 1000);
  QTest::qWait(20);
  EXPECT_FALSE(panel("scene").isVisible()) << "hidden where they have room: a wish";
}

/// A person drags the border between two panels, or between panels and scene.
void drag(QWidget& area, QPoint from, QPoint by) {
  QTest::mousePress(&area, Qt::LeftButton, {}, from);
  for (const double part : {0.3, 0.7, 1.0}) {
    QMouseEvent move(QEvent::MouseMove, from + by * part, area.mapToGlobal(from + by * part), Qt::LeftButton,
                     Qt::LeftButton, {});
    QApplication::sendEvent(&area, &move);
    QTest::qWait(20);
  }
  QTest::mouseRelease(&area, Qt::LeftButton, {}, from + by);
  QTest::qWait(40);
}

/// After 640 x 400 the right column stayed at 240 pixels and the plots without height.
TEST_F(Layout, SizesThatAPersonChoseComeBackWhenThereIsRoomAgain) {
  const QRect candidates = panel("candidates").geometry(), plots = panel("plots").geometry();
  drag(area(), {candidates.left() - 2, candidates.center().y()}, {-90, 0});
  drag(area(), {plots.center().x(), plots.top() - 2}, {0, -60});
  const int width = panel("candidates").width(), height = panel("plots").height();
  ASSERT_NEAR(width, candidates.width() + 90, 10);
  ASSERT_NEAR(height, plots.height() + 60, 10);
  const int settings = panel("settings").height(), left = panel("library").width();
  for (const QSize size : {QSize(640, 400), QSize(1280, 720), QSize(900, 560), QSize(1600, 1000)}) {
    window().resize(size);
    QTest::qWait(40);
  }
  EXPECT_NEAR(panel("candidates").width(), width, 2);
  EXPECT_NEAR(panel("plots").height(), height, 2);
  EXPECT_NEAR(panel("settings").height(), settings, 4);
  EXPECT_NEAR(panel("library").width(), left, 2);
}

/// One row of them was left at 1280 x 720, the map of the candidates took the room.
TEST_F(Layout, FiveSettingsAreInViewBelowTheCandidates) {
  const auto whole_rows = [] {
    int rows = 0;
    for (const auto* row : window().settings().findChildren<widgets::SettingRow*>())
      rows += row->visibleRegion().boundingRect().height() == row->height();
    return rows;
  };
  const auto candidate_rows = [] {
    const auto* list = window().candidates().findChild<widgets::CandidateList*>();
    return list->parentWidget()->visibleRegion().boundingRect().height() / widgets::CandidateList::row_height;
  };
  for (const QSize size : {QSize(1600, 1000), QSize(1280, 720), QSize(1600, 1000)}) {
    window().resize(size);
    QTest::qWait(40);
    EXPECT_EQ(window().size(), size);
    EXPECT_GE(whole_rows(), 5) << size.height();
    EXPECT_GE(candidate_rows(), 3) << size.height();
    EXPECT_LE(panel("candidates").geometry().bottom(), panel("settings").geometry().top());
  }
  window().resize(1280, 720);
  window().resetLayout();
  QTest::qWait(40);
  EXPECT_GE(whole_rows(), 5) << "also from the beginning";
}

/// Two panels that a person sees, one over the other; empty if there are none.
std::string drawn_over_another(const PanelArea& area) {
  for (const QDockWidget* one : area.panels())
    for (const QDockWidget* other : area.panels())
      if (one < other && !one->visibleRegion().isEmpty() && !other->visibleRegion().isEmpty() &&
          one->geometry().intersects(other->geometry()))
        return one->objectName().toStdString() + " and " + other->objectName().toStdString();
  return {};
}

/// The settings had no title and presets below the video, the library had none below the recording: the
/// tallest panel of a shared place, and those at the left, were not counted.
TEST_F(Layout, NoPanelIsDrawnOverAnotherInASmallWindow) {
  auto& recording = *window().findChild<widgets::TakePanel*>();
  RecordedTakes takes;
  for (const std::int64_t id : {1, 2, 3}) takes.put({id, "take", 0, 1, 60, {}});
  recording.setTakes(takes);
  const auto open = [](QSize size, const std::vector<const char*>& panels) {
    window().resize(size);
    for (const char* opened : panels) {
      area().want(opened, true);
      QTest::qWait(80);
      EXPECT_TRUE(until([] { return drawn_over_another(area()).empty(); }))
          << drawn_over_another(area()) << " at " << size.height() << " with " << opened;
    }
    for (const char* opened : panels) area().want(opened, false);
  };
  for (const QSize size : {QSize(1280, 720), QSize(1280, 700)})
    open(size, {"video", "recording", "connection"});
  open({1100, 640}, {"recording", "connection"});
  recording.setTakes({});
}

/// The view menu had a second column, and covered the whole window.
TEST_F(Layout, EveryMenuIsOneColumnOnAScreenOfAThousandLines) {
  ASSERT_LE(window().screen()->size().height(), 1000);
  for (const QAction* action : window().menuBar()->actions())
    if (QMenu* menu = action->menu(); menu && menu->actions().size() > 1) {
      menu->adjustSize();  // lays it out
      EXPECT_EQ(menu->actionGeometry(menu->actions().back()).left(),
                menu->actionGeometry(menu->actions().front()).left())
          << action->text().toStdString();
    }
}

/// The columns were as narrow as in the small window: words and a list of the settings were cut.
TEST_F(Layout, AnArrangementOfASmallWindowHasItsUsualWidthsInALargeOne) {
  QTest::qWait(40);
  const int left = panel("library").width(), right = panel("settings").width();
  window().resize(640, 400);
  window().resetLayout();
  QTest::qWait(60);
  const WindowLayout small = area().state();
  window().resize(1600, 1000);
  window().resetLayout();
  QTest::qWait(60);
  ASSERT_TRUE(area().setState(small));
  const auto is_near = [](const char* name, int width) { return std::abs(panel(name).width() - width) <= 2; };
  EXPECT_TRUE(until([&] { return is_near("library", left) && is_near("settings", right); }))
      << panel("library").width() << " for " << left << ", " << panel("settings").width() << " for " << right;
}

/// Of a window that is large again before it is closed.
TEST_F(Layout, WidthsThatAPersonChoseAreSavedFromASmallWindowToo) {
  QTest::qWait(40);
  const QRect candidates = panel("candidates").geometry();
  drag(area(), {candidates.left() - 2, candidates.center().y()}, {-90, 0});
  const int width = panel("candidates").width();
  window().resize(640, 400);
  QTest::qWait(60);
  const auto small = parse_layout(text_of(area().state()), "small.json");
  ASSERT_TRUE(small);
  window().resize(1600, 1000);
  window().resetLayout();
  QTest::qWait(60);
  ASSERT_NE(panel("candidates").width(), width);
  ASSERT_TRUE(area().setState(*small));
  EXPECT_TRUE(until([&] { return std::abs(panel("candidates").width() - width) <= 2; }))
      << panel("candidates").width() << " for " << width;
}

TEST_F(Layout, APanelThatIsMovedForgetsTheSizeItHadElsewhere) {
  QTest::qWait(40);
  area().want("plots", false);
  area().addDockWidget(Qt::BottomDockWidgetArea, &panel("settings"));
  area().resizeDocks({&panel("settings")}, {150}, Qt::Vertical);
  QTest::qWait(40);
  const int height = panel("settings").height();
  window().resize(1590, 1000);
  QTest::qWait(40);
  EXPECT_NEAR(panel("settings").height(), height, 2);
}

TEST_F(Layout, ASideWhosePanelsWereAllClosedCanBeAskedBack) {
  area().want("scene", false);
  area().want("library", false);
  window().showLeft(false);
  window().showLeft(true);
  EXPECT_TRUE(panel("scene").isVisible());
  EXPECT_TRUE(panel("library").isVisible());
}

TEST_F(Layout, APanelWithItsButtonClosedIsNoLongerTicked) {
  const auto toggle = [] {
    for (QAction* action : window().actions())
      if (action->text() == "Plots panel") return action;
    return static_cast<QAction*>(nullptr);
  };
  ASSERT_TRUE(toggle());
  panel("plots").close();
  EXPECT_FALSE(toggle()->isChecked());
  toggle()->trigger();
  EXPECT_TRUE(panel("plots").isVisible());
  EXPECT_TRUE(toggle()->isChecked());
}

TEST_F(Layout, AFloatingPanelOutsideEveryScreenIsBroughtBack) {
  panel("settings").setFloating(true);
  panel("settings").move(-5000, 9000);
  QTest::qWait(20);
  const WindowLayout layout = window().layoutOfPanels();
  window().resetLayout();
  ASSERT_TRUE(window().setLayoutOfPanels(layout));
  const QRect screen = QGuiApplication::primaryScreen()->availableGeometry();
  EXPECT_TRUE(screen.intersects(panel("settings").geometry()));
}

TEST_F(Layout, AWindowOutsideEveryScreenIsBroughtBack) {
  QWidget lost;
  lost.setGeometry(-4000, -4000, 700, 500);
  bring_onto_screen(lost);
  EXPECT_TRUE(QGuiApplication::primaryScreen()->availableGeometry().contains(lost.geometry().center()));
  const QRect before = lost.geometry();
  bring_onto_screen(lost);
  EXPECT_EQ(lost.geometry(), before);
}

/// The status bar was below the screen.
TEST_F(Layout, AWindowAsLargeAsTheScreenHasItsFrameOnIt) {
  const QRect room = QGuiApplication::primaryScreen()->availableGeometry();
  QWidget large;
  large.setGeometry(QRect(room.topLeft() + QPoint(0, 30), room.size()));
  fit_onto_screen(large);
  EXPECT_TRUE(room.contains(large.geometry()));
  EXPECT_LT(large.height(), room.height());
  large.setMinimumSize(room.size() + QSize(200, 100));
  fit_onto_screen(large);
  EXPECT_EQ(large.pos(), room.topLeft()) << "as much of it as there is room for";
  QWidget small;
  small.setGeometry(QRect(room.topLeft() + QPoint(40, 40), QSize(300, 200)));
  fit_onto_screen(small);
  EXPECT_EQ(small.geometry(), QRect(room.topLeft() + QPoint(40, 40), QSize(300, 200)));
}

TEST(WindowLayout, IsTheSameAfterWritingAndReading) {
  WindowLayout layout;
  layout.docks = QByteArray("\0\1\2", 3);
  layout.known = QStringList{"scene", "plots"};
  layout.shown = QStringList{"plots"};
  layout.sides = {true, {}, false};
  layout.timeline_height = 230;
  layout.sizes = std::map<QString, QSize>{{"scene", {0, 410}}, {"plots", {900, 172}}};
  const auto read = parse_layout(text_of(layout), "a.json");
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, layout);
}

TEST(WindowLayout, ATimelineIsNoHigherThanAnyScreen) {
  const auto read = parse_layout("{\"abrazo_layout\": 1, \"timeline_height\": 2147483647}", "a.json");
  ASSERT_TRUE(read);
  EXPECT_LT(read->timeline_height.value(), 20'000);
}

TEST(RememberedView, ACameraComesBackAndWhatIsNoneDoesNot) {
  const auto turn = camera_turn_of(text_of(CameraTurn{-3, 1.5}));
  ASSERT_TRUE(turn);
  EXPECT_EQ(turn->azimuth_rad, -3);
  EXPECT_EQ(turn->elevation_rad, 1.5);
  EXPECT_NEAR(camera_turn_of("7 0")->azimuth_rad, 7 - 2 * std::numbers::pi, 1e-12) << "the same direction";
  for (const char* none : {"", "1", "1 2 3", "nan 0", "0 nan", "inf 0", "0 2", "0 -inf", "north 0"})
    EXPECT_FALSE(camera_turn_of(none)) << none;
}

}  // namespace
}  // namespace abrazo::app::layout_test
