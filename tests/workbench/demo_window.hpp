#pragma once

#include <gtest/gtest.h>

#include <QAction>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "tests/workbench/until.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app {

/// One whole window with a home folder of its own for all tests of a suite: opening it takes seconds.
class DemoWindow : public testing::Test {
 protected:
  /// For SetUpTestSuite: a window with every action and nothing open.
  /// @param playsAsLive  its clips are performed without end: for what a live session does
  static void showWindow(QSize size, bool playsAsLive = true) {
    s_home = std::make_unique<QTemporaryDir>();
    qputenv("ABRAZO_HOME", s_home->path().toUtf8());
    s_remembered = std::make_unique<UserSettings>();
    s_window = std::make_unique<MainWindow>(*s_remembered);
    s_window->setTheme(widgets::Theme::Dark);
    s_window->setPlaysAsLive(playsAsLive);
    s_window->resize(size);
    add_all_actions(*s_window);
    s_window->show();
  }
  /// For SetUpTestSuite: the same on the generated dance, so many frames of which were solved and shown.
  static void showDemo(QSize size, std::uint64_t frames = 30) {
    showWindow(size);
    s_window->openDemo();
    until([frames] { return ticker().shown() && ticker().shown()->index >= frames; });
  }
  static void TearDownTestSuite() {
    s_window.reset();
    s_remembered.reset();
    s_home.reset();
  }

  /// With the keyboard, and nothing to undo.
  void SetUp() override {
    s_window->activateWindow();
    (void)QTest::qWaitForWindowActive(s_window.get(), 300);  // a bare display has no window manager
    s_window->setFocus();
    s_window->undoStack().clear();
    turn();
  }

  static MainWindow& window() { return *s_window; }
  static UserSettings& remembered() { return *s_remembered; }
  static const QTemporaryDir& home() { return *s_home; }
  static FrameTicker& ticker() { return s_window->ticker(); }

  /// Lets the window work off what was asked of it.
  static void turn() { QTest::qWait(40); }
  static void press(int key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(s_window.get(), static_cast<Qt::Key>(key), modifiers);
    turn();
  }
  /// By its words in the menu; null when there is none.
  static QAction* action(const QString& text) {
    for (QAction* each : s_window->actions())
      if (each->text() == text) return each;
    return nullptr;
  }

 private:
  static inline std::unique_ptr<QTemporaryDir> s_home;
  static inline std::unique_ptr<UserSettings> s_remembered;
  static inline std::unique_ptr<MainWindow> s_window;
};

}  // namespace abrazo::app
