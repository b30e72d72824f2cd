#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QUndoCommand>

#include "app/workbench/compare/comparison_desk.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "widgets/compare/compare_panel.hpp"
#include "widgets/settings/settings_panel.hpp"

namespace abrazo::app {
namespace {

using widgets::ComparePanel;

/// A from one value to another, in the session that it was frozen in.
class ChangeFrozen : public QUndoCommand {
 public:
  ChangeFrozen(ComparisonDesk& desk, const Settings& after)
      : m_desk(desk), m_session(desk.session()), m_before(desk.frozen()), m_after(after) {}
  void redo() override { set(m_after); }
  void undo() override { set(m_before); }

 private:
  void set(const std::optional<Settings>& frozen) {
    if (m_desk.session() == m_session) m_desk.setFrozen(frozen);
  }

  ComparisonDesk& m_desk;
  int m_session;
  std::optional<Settings> m_before, m_after;
};

void swap(MainWindow& window, ComparisonDesk& desk) {
  const Settings b = window.document().settings();
  if (!desk.frozen() || *desk.frozen() == b) return;
  const Settings a = *desk.frozen();
  window.undoStack().beginMacro("swap A and B");
  window.undoStack().push(new ChangeFrozen(desk, b));
  window.document().adopt(a, "settings of A");
  window.undoStack().endMacro();
}

void adopt(MainWindow& window, const ComparisonDesk& desk) {
  if (desk.frozen()) window.document().adopt(*desk.frozen(), "settings of A");
}

void add_spans(MainWindow& window, QMenu* menu, ComparePanel& panel) {
  const std::pair<const char*, WhatIfSpan> spans[] = {{"What if: this frame", WhatIfSpan::Frame},
                                                      {"What if: 2 s to here", WhatIfSpan::TwoSeconds},
                                                      {"What if: 10 s to here", WhatIfSpan::TenSeconds},
                                                      {"What if: from in to out", WhatIfSpan::InToOut}};
  for (const auto& [name, span] : spans)
    add_action(window, menu, name, {}, [&window, &panel, span = span] {
      window.panels().want("compare", true);
      if (window.ticker().playback().state != Playback::State::Parked) window.ticker().pause();
      panel.chooseSpan(span);
    });
}

}  // namespace

void add_compare_actions(MainWindow& window) {
  auto* panel = new ComparePanel;
  window.colour(panel);
  QDockWidget* dock = window.addPanel("compare", "Compare", panel, Qt::RightDockWidgetArea, true);
  if (QDockWidget* first = window.panels().panel("candidates")) first->raise();
  auto* desk = new ComparisonDesk(window.document(), window.ticker(), window.scene(), *panel);
  QObject::connect(panel, &ComparePanel::freezeRequested, desk, &ComparisonDesk::freeze);
  QObject::connect(panel, &ComparePanel::clearRequested, desk, [desk] { desk->setFrozen({}); });
  QObject::connect(panel, &ComparePanel::asideRequested, desk, &ComparisonDesk::setAside);
  QObject::connect(panel, &ComparePanel::swapRequested, desk, [&window, desk] { swap(window, *desk); });
  QObject::connect(panel, &ComparePanel::adoptRequested, desk, [&window, desk] { adopt(window, *desk); });

  QMenu* menu = menu_of(window, "Compare");
  add_action(window, menu, "Freeze the settings as A", {QKeySequence("A")}, [&window, desk, dock] {
    window.panels().want("compare", true);
    dock->raise();
    desk->freeze();
  });
  std::vector<QAction*> of_frozen = {
      add_action(window, menu, "Swap A and B", {QKeySequence("Shift+A")},
                 [&window, desk] { swap(window, *desk); }),
      add_action(window, menu, "Adopt the settings of A", {}, [&window, desk] { adopt(window, *desk); }),
      add_action(window, menu, "Let A go", {}, [desk] { desk->setFrozen({}); })};
  QAction* aside = add_action(window, menu, "Live keeps A", {QKeySequence("Alt+A")}, [] {});
  aside->setCheckable(true);
  QObject::connect(aside, &QAction::triggered, desk, &ComparisonDesk::setAside);
  QObject::connect(desk, &ComparisonDesk::asideChanged, aside, &QAction::setChecked);
  for (QAction* action : of_frozen) {
    action->setEnabled(false);
    QObject::connect(desk, &ComparisonDesk::frozenChanged, action, &QAction::setEnabled);
  }
  menu->addSeparator();
  add_spans(window, menu, *panel);
}

}  // namespace abrazo::app
