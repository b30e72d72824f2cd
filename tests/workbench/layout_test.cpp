#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QFile>
#include <QGuiApplication>
#include <QScreen>
#include <QSplitter>
#include <QTemporaryDir>
#include <QTest>

#include "app/workbench/actions/actions.hpp"
#include "app/workbench/layouts.hpp"
#include "app/workbench/main_window.hpp"
#include "app/workbench/panel_area.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/scene/scene_view.hpp"

namespace abrazo::app {
namespace {

/// A window with everything in it and nothing open: enough for what concerns its panels.
class Layout : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    s_home = new QTemporaryDir;
    qputenv("ABRAZO_HOME", s_home->path().toUtf8());
    s_remembered = new UserSettings;
    s_window = new MainWindow(*s_remembered);
    add_all_actions(*s_window);
    s_window->resize(1600, 1000);
    s_window->show();
  }
  static void TearDownTestSuite() {
    delete s_window;
    delete s_remembered;
    delete s_home;
  }
  void SetUp() override {
    s_window->resize(1600, 1000);
    s_window->resetLayout();
    s_window->activateWindow();
    QTest::qWait(20);
  }

  static PanelArea& area() { return s_window->panels(); }
  static QDockWidget& panel(const char* id) { return *area().panel(id); }
  static Layouts& layouts() { return *s_window->findChild<Layouts*>(); }
  static Qt::DockWidgetArea side(const char* id) { return area().dockWidgetArea(&panel(id)); }
  static void write(const QString& path, const QByteArray& content) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(content);
  }

  static inline QTemporaryDir* s_home = nullptr;
  static inline UserSettings* s_remembered = nullptr;
  static inline MainWindow* s_window = nullptr;
};

TEST_F(Layout, PlotsAreBelowTheSceneAndTheTimelineIsBelowEverything) {
  const QRect plots = panel("plots").geometry();
  EXPECT_GE(plots.left(), panel("scene").geometry().right());
  EXPECT_LE(plots.right(), panel("candidates").geometry().left());
  EXPECT_EQ(area().width(), s_window->width());
  EXPECT_GT(panel("settings").geometry().top(), panel("candidates").geometry().top());
  EXPECT_GT(panel("library").geometry().top(), panel("scene").geometry().top());
}

TEST_F(Layout, PanelsAreFloatedMovedAndClosedAndTheSceneKeepsItsParent) {
  const QWidget* parent = s_window->scene().parentWidget();
  panel("plots").setFloating(true);
  panel("settings").setFloating(true);
  area().addDockWidget(Qt::LeftDockWidgetArea, &panel("candidates"));
  area().tabifyDockWidget(&panel("scene"), &panel("library"));
  area().want("plots", false);
  layouts().choose("Present");
  layouts().choose("Explore");
  s_window->resize(700, 420);
  QTest::qWait(20);
  EXPECT_EQ(s_window->scene().parentWidget(), parent);
}

TEST_F(Layout, AnArrangementComesBackAsItWasSaved) {
  area().addDockWidget(Qt::LeftDockWidgetArea, &panel("settings"));
  area().want("plots", false);
  panel("library").setFloating(true);
  ASSERT_TRUE(layouts().save("my / own"));
  EXPECT_EQ(layouts().own(), QStringList{"my / own"});
  s_window->resetLayout();
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
  s_window->close();  // saves
  s_window->resetLayout();
  s_window->show();
  EXPECT_TRUE(panel("library").isVisible());
  EXPECT_TRUE(layouts().restoreLast());
  EXPECT_FALSE(panel("library").isVisible());
}

TEST_F(Layout, ABrokenOrForeignArrangementIsToldAndTheUsualOneIsShown) {
  const std::vector<std::pair<QByteArray, QString>> cases = {
      {"no layout", "is no layout"},
      {"{\"abrazo_layout\": 99}", "of another version"},
      {"{\"abrazo_layout\": 1, \"docks\": \"AAAA\", \"shown\": []}", "does not fit"}};
  for (const auto& [content, message] : cases) {
    area().want("plots", false);
    write(s_remembered->folder() + "/layout.json", content);
    EXPECT_FALSE(layouts().restoreLast());
    EXPECT_TRUE(s_window->messages().text().contains(message)) << s_window->messages().text().toStdString();
    EXPECT_TRUE(panel("plots").isVisible());
  }
}

TEST_F(Layout, APanelThatALayoutDoesNotKnowStandsInItsUsualPlace) {
  WindowLayout older = s_window->layoutOfPanels();
  older.known.removeAll("plots");
  older.shown.removeAll("plots");
  ASSERT_TRUE(s_window->setLayoutOfPanels(older));
  EXPECT_TRUE(panel("plots").isVisible());
  EXPECT_EQ(side("plots"), Qt::BottomDockWidgetArea);
}

TEST_F(Layout, BuiltInArrangements) {
  layouts().choose("Present");
  for (const QDockWidget* each : area().panels())
    EXPECT_FALSE(each->isVisible()) << each->objectName().toStdString();
  layouts().choose("Tune");
  EXPECT_TRUE(panel("settings").isVisible());
  EXPECT_FALSE(panel("scene").isVisible());
  layouts().choose("Explore");
  EXPECT_TRUE(panel("scene").isVisible());
  EXPECT_FALSE(layouts().save("Explore")) << "a built-in name cannot be taken";
}

TEST_F(Layout, ASmallWindowHidesPanelsWithoutForgettingThem) {
  s_window->resize(640, 400);
  QTest::qWait(20);
  for (const char* id : {"scene", "library", "candidates", "settings", "plots"}) {
    EXPECT_FALSE(panel(id).isVisible()) << id;
    EXPECT_TRUE(area().isWanted(id)) << id;
  }
  QTest::keyClick(s_window, Qt::Key_F8);
  EXPECT_TRUE(panel("scene").isVisible()) << "asked for, so it is shown whatever the size";
  QTest::keyClick(s_window, Qt::Key_F8);
  EXPECT_FALSE(panel("scene").isVisible());
  s_window->resetLayout();
  s_window->resize(1600, 1000);
  QTest::qWait(20);
  EXPECT_TRUE(panel("scene").isVisible());
  EXPECT_TRUE(panel("plots").isVisible());
}

TEST_F(Layout, ASideWhosePanelsWereAllClosedCanBeAskedBack) {
  area().want("scene", false);
  area().want("library", false);
  s_window->showLeft(false);
  s_window->showLeft(true);
  EXPECT_TRUE(panel("scene").isVisible());
  EXPECT_TRUE(panel("library").isVisible());
}

TEST_F(Layout, APanelWithItsButtonClosedIsNoLongerTicked) {
  const auto toggle = [] {
    for (QAction* action : s_window->actions())
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
  const WindowLayout layout = s_window->layoutOfPanels();
  s_window->resetLayout();
  ASSERT_TRUE(s_window->setLayoutOfPanels(layout));
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

TEST(WindowLayout, IsTheSameAfterWritingAndReading) {
  WindowLayout layout;
  layout.docks = QByteArray("\0\1\2", 3);
  layout.known = QStringList{"scene", "plots"};
  layout.shown = QStringList{"plots"};
  layout.sides = {true, {}, false};
  layout.timeline_height = 230;
  const auto read = parse_layout(text_of(layout), "a.json");
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, layout);
}

}  // namespace
}  // namespace abrazo::app
