#pragma once

// The whole window on the generated dance, and what tests of its keys look at.

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QTreeView>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "app/workbench/compare/comparison_desk.hpp"
#include "app/workbench/keys/key_entry.hpp"
#include "app/workbench/keys/shortcut_dialog.hpp"
#include "app/workbench/keys/shortcuts.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "tests/workbench/until.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/selection_model.hpp"
#include "widgets/library/take_list.hpp"
#include "widgets/scene/panel/scene_tree.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/settings/settings_panel.hpp"
#include "widgets/timeline/quick_entry.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app {

using State = Playback::State;
using widgets::ScenePart;
using widgets::Selection;

inline constexpr double quarter = 1.57079632679;

inline void turn() {
  QTest::qWait(30);
}

inline MainWindow* window = nullptr;
inline FrameTicker& ticker() {
  return window->ticker();
}
inline const Playback& playback() {
  return ticker().playback();
}
inline widgets::SceneView& scene() {
  return window->scene();
}
inline const Selection& selection() {
  return window->selection().selection();
}
inline const widgets::OrbitCamera& camera() {
  return scene().camera();
}
inline bool shows(ScenePart part) {
  return scene().visibility()[static_cast<std::size_t>(part)];
}
inline std::size_t markers() {
  return window->timeline().markers().all().size();
}
inline widgets::QuickEntry* entry() {
  auto* field = window->findChild<widgets::QuickEntry*>();
  return field && field->isVisible() ? field : nullptr;
}
inline QDialog* dialog(const QString& name) {
  auto* found = window->findChild<QDialog*>(name);
  return found && found->isVisible() ? found : nullptr;
}

inline bool looks_from(double azimuth_rad, double elevation_rad) {
  return std::abs(std::remainder(camera().azimuth_rad - azimuth_rad, 4 * quarter)) < 1e-6 &&
         std::abs(camera().elevation_rad - elevation_rad) < 1e-3;
}

inline void mark(double time_s) {
  Markers next = window->timeline().markers();
  const int id = next.add(time_s);
  window->document().put(SubjectMarkers{"", next});
  window->timeline().selectMarker(id);
}

inline void select_leader_root() {
  window->selection().select(Selection::joint(0));
}
inline void focus_scene() {
  for (QWidget* child : scene().findChildren<QWidget*>())
    if (child->focusPolicy() == Qt::StrongFocus) return child->setFocus();
}
/// Parked in the past, with nothing selected, set or open.
class KeyWindow : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    s_home = std::make_unique<QTemporaryDir>();
    qputenv("ABRAZO_HOME", s_home->path().toUtf8());
    qputenv("HOME", s_home->path().toUtf8());
    s_remembered = std::make_unique<UserSettings>();
    window = new MainWindow(*s_remembered);
    window->setTheme(widgets::Theme::Dark);
    window->resize(1500, 950);
    add_all_actions(*window);
    window->show();
    window->setPlaysAsLive(true);
    window->openDemo();
    until([] { return playback().last_s > 3; });
  }
  static void TearDownTestSuite() {
    delete std::exchange(window, nullptr);
    s_remembered.reset();
    s_home.reset();
  }
  void SetUp() override {
    // A key before this one may have begun another session.
    ASSERT_TRUE(until([] { return ticker().shown() && playback().last_s > 3; })) << "the demo did not start";
    for (QDialog* each : window->findChildren<QDialog*>()) each->close();
    if (auto* field = entry()) QTest::keyClick(field->findChild<QLineEdit*>(), Qt::Key_Escape);
    window->setWindowState(Qt::WindowNoState);
    window->show();
    window->activateWindow();
    (void)QTest::qWaitForWindowActive(window, 300);
    window->resetLayout();
    if (auto* focused = QApplication::focusWidget()) focused->clearFocus();
    window->setFocus();
    settle();
    turn();
  }

  static void settle() {
    for (QAction* action : window->actions())
      if (action->text() == "Hold the input still" || action->text() == "Live keeps A")
        if (action->isChecked()) action->trigger();
    window->findChild<ComparisonDesk*>()->setFrozen({});
    window->candidates().liftAll();
    window->document().changeSetting("alpha", "0.5");
    window->undoStack().clear();
    window->selection().select({});
    scene().showHidden();
    scene().setOptions({});
    scene().setVisibility(widgets::default_visibility);
    scene().setMorphStep(1'000);
    if (window->takes().isPlaying()) window->takes().togglePlay();
    window->document().put(SubjectMarkers{"", {}});
    window->timeline().selectMarker(0);
    ticker().setRange(0, 0);
    ticker().setLoop(false);
    ticker().setSpeed(1);
    ticker().seek(1.5);
  }

  static void press(int key, Qt::KeyboardModifiers held = {}) {
    QWidget* focused = QApplication::focusWidget();
    QTest::keyClick(focused && focused->window() == window ? focused : window, static_cast<Qt::Key>(key),
                    held);
  }

 private:
  static inline std::unique_ptr<QTemporaryDir> s_home;
  static inline std::unique_ptr<UserSettings> s_remembered;
};

}  // namespace abrazo::app
