#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QMenu>
#include <QSignalBlocker>
#include <QTabBar>

#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/layouts.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "app/workbench/shell/panel_focus.hpp"
#include "app/workbench/shell/window_place.hpp"
#include "widgets/common/message_log.hpp"

namespace abrazo::app {
namespace {

void ask_name_and_save(MainWindow& window, Layouts& layouts) {
  bool ok = false;
  const QString name =
      QInputDialog::getText(&window, "Save layout", "Name of the layout:", QLineEdit::Normal, {}, &ok);
  if (ok && layouts.save(name.trimmed()))
    window.messages().showInformation("The layout is saved as " + name.trimmed());
}

/// A person's own layouts in a menu; those of the same object name are taken out first.
void fill(MainWindow& window, const Layouts& layouts, QMenu* menu, QAction* before, const QString& verb,
          const std::function<void(const QString&)>& act) {
  for (QAction* old : menu->actions())
    if (old->objectName() == "own layout") delete old;
  for (const QString& name : layouts.own()) {
    auto* action = new QAction(verb + name, &window);
    action->setObjectName("own layout");
    QObject::connect(action, &QAction::triggered, &window, [act, name] { act(name); });
    menu->insertAction(before, action);
    window.addAction(action);  // found by the search of commands
  }
}

/// In the row of the menus, as long as the menus have room beside them.
class TaskTabs : public QTabBar {
 public:
  static constexpr int tallest_px = 26;  // the row stays as high as the menus make it

  TaskTabs(QMainWindow& window, Layouts& layouts) : m_window(window) {
    setAccessibleName("Task");
    setDrawBase(false);
    setExpanding(false);
    setMaximumHeight(tallest_px);
    setStyleSheet("QTabBar::tab { padding: 2px 10px; }");  // with the line below the chosen one
    setFocusPolicy(Qt::TabFocus);
    for (const QString& task : Layouts::builtIn()) setTabToolTip(addTab(task), "The panels for this task");
    connect(this, &QTabBar::currentChanged, &layouts,
            [this, &layouts](int tab) { layouts.choose(tabText(tab)); });
    connect(&layouts, &Layouts::taskChanged, this, [this](const QString& task) {
      const QSignalBlocker quiet(this);
      setCurrentIndex(static_cast<int>(Layouts::builtIn().indexOf(task)));
    });
    window.installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    constexpr int least_width = 1000;
    if (watched == &m_window && event->type() == QEvent::Resize) setVisible(m_window.width() >= least_width);
    return QTabBar::eventFilter(watched, event);
  }

 private:
  QMainWindow& m_window;
};

void add_tabs(MainWindow& window, Layouts& layouts) {
  title_row(window).insertWidget(0, new TaskTabs(window, layouts));
}

}  // namespace

Layouts& add_layout_actions(MainWindow& window) {
  auto* layouts = new Layouts(window);
  QObject::connect(&window, &MainWindow::closing, layouts, &Layouts::saveLast);
  QMenu* menu = menu_of(window, "View")->addMenu("Layouts");
  for (const QString& name : Layouts::builtIn())
    add_action(window, menu, "Layout: " + name, {}, [layouts, name] { layouts->choose(name); });
  QAction* end_of_own = menu->addSeparator();
  add_action(window, menu, "Save layout…", {}, [&window, layouts] { ask_name_and_save(window, *layouts); });
  QMenu* remove = menu->addMenu("Delete layout");
  add_action(window, menu, "Reset layout", {}, [layouts] { layouts->reset(); });
  add_tabs(window, *layouts);
  const auto refill = [&window, menu, remove, end_of_own, layouts] {
    fill(window, *layouts, menu, end_of_own,
         "Layout: ", [layouts](const QString& name) { layouts->choose(name); });
    fill(window, *layouts, remove, nullptr,
         "Delete layout: ", [layouts](const QString& name) { layouts->remove(name); });
    remove->setEnabled(!remove->isEmpty());
  };
  QObject::connect(layouts, &Layouts::ownChanged, menu, refill, Qt::QueuedConnection);
  refill();
  menu_of(window, "View")->addSeparator();
  add_action(window, menu_of(window, "View"), "Next panel", {QKeySequence("F6")},
             [&window] { focus_panel(window, 1); });
  add_action(window, menu_of(window, "View"), "Previous panel", {QKeySequence("Shift+F6")},
             [&window] { focus_panel(window, -1); });
  auto* log = new widgets::MessageLog;
  window.colour(log);
  QObject::connect(&window.messages(), &widgets::MessageBar::told, log, &widgets::MessageLog::add);
  window.addPanel("messages", "Messages", log, Qt::BottomDockWidgetArea, false);
  add_action(window, menu_of(window, "View"), "Messages", {},
             [&window] { window.panels().want("messages", true); });
  return *layouts;
}

void restore_last_layout(MainWindow& window, Layouts& layouts) {
  window.restoreGeometry(window.remembered().geometry());
  fit_onto_screen(window);
  layouts.restoreLast();
}

}  // namespace abrazo::app
