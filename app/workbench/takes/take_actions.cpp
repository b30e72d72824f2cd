#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QUndoCommand>

#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "app/workbench/takes/take_desk.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/takes/take_panel.hpp"
#include "widgets/takes/take_rows.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app {
namespace {

using widgets::TakePanel;

/// Of no use once another session runs: its takes are others.
class TakeChange : public QUndoCommand {
 public:
  TakeChange(TakeDesk& desk, RecordedTake take, const QString& what)
      : QUndoCommand(what), m_desk(desk), m_take(std::move(take)), m_session(desk.session()) {}
  void redo() final { is_of_this_session() ? apply(m_desk) : setObsolete(true); }
  void undo() final { is_of_this_session() ? revert(m_desk) : setObsolete(true); }

 protected:
  virtual void apply(TakeDesk& desk) = 0;
  virtual void revert(TakeDesk& desk) = 0;
  const RecordedTake& take() const { return m_take; }

 private:
  bool is_of_this_session() const { return m_session == m_desk.session(); }

  TakeDesk& m_desk;
  RecordedTake m_take;
  int m_session;
};

class RenameTake : public TakeChange {
 public:
  RenameTake(TakeDesk& desk, const RecordedTake& take, std::string name)
      : TakeChange(desk, take, "rename take"), m_name(std::move(name)) {}

 private:
  void apply(TakeDesk& desk) override { desk.rename(take().id, m_name); }
  void revert(TakeDesk& desk) override { desk.rename(take().id, take().name); }
  std::string m_name;
};

class RemoveTake : public TakeChange {
 public:
  RemoveTake(TakeDesk& desk, const RecordedTake& take) : TakeChange(desk, take, "delete take") {}

 private:
  void apply(TakeDesk& desk) override { desk.remove(take().id); }
  void revert(TakeDesk& desk) override { desk.restore(take()); }
};

void rename(MainWindow& window, TakeDesk& desk, qint64 id, const QString& name) {
  const RecordedTake* take = desk.takes().find(id);
  const std::string why_not = desk.takes().why_not(id, name.toStdString());
  if (!why_not.empty()) return window.messages().showError(QString::fromStdString(why_not));
  if (take && !desk.refusesChange())
    window.undoStack().push(new RenameTake(desk, *take, name.trimmed().toStdString()));
}

void remove(MainWindow& window, TakeDesk& desk, qint64 id) {
  const RecordedTake* take = desk.takes().find(id);
  if (!take || (desk.isRecording() && take == &desk.takes().all().back()))
    return window.messages().showInformation("This take is being recorded; end it first (Ctrl+R)");
  if (!desk.refusesChange()) window.undoStack().push(new RemoveTake(desk, *take));
}

void connect_panel(MainWindow& window, TakePanel& panel, TakeDesk& desk) {
  QObject::connect(&panel, &TakePanel::recordRequested, &desk, &TakeDesk::toggle);
  QObject::connect(&panel, &TakePanel::againRequested, &desk, &TakeDesk::again);
  QObject::connect(&panel, &TakePanel::everythingRequested, &desk, &TakeDesk::keepEverything);
  QObject::connect(&panel, &TakePanel::goToRequested, &desk, &TakeDesk::goTo);
  QObject::connect(&window.timeline(), &widgets::TimelineView::takeRequested, &desk, &TakeDesk::goTo);
  QObject::connect(&panel, &TakePanel::renameRequested, &window,
                   [&](qint64 id, const QString& name) { rename(window, desk, id, name); });
  QObject::connect(&panel, &TakePanel::removeRequested, &window,
                   [&](qint64 id) { remove(window, desk, id); });
  QObject::connect(&panel, &TakePanel::nameEdited, &window,
                   [&](const QString& name) { window.remembered().setTakeName(name); });
  QObject::connect(&panel, &TakePanel::countdownEdited, &window,
                   [&](int seconds) { window.remembered().setTakeCountdown(seconds); });
}

}  // namespace

TakeDesk& add_take_actions(MainWindow& window) {
  auto* panel = new TakePanel;
  window.colour(panel);
  panel->setTypedName(window.remembered().takeName());
  panel->setCountdown(window.remembered().takeCountdown());
  QDockWidget* dock = window.addPanel("recording", "Recording", panel, Qt::LeftDockWidgetArea, false);
  auto* desk = new TakeDesk(window, *panel);
  connect_panel(window, *panel, *desk);
  const auto show = [&window, dock] {
    window.panels().want("recording", true);
    dock->raise();
  };

  QMenu* menu = menu_of(window, "Live");
  add_action(window, menu, "Record a take, or end it", {QKeySequence("Ctrl+R")}, [desk, show] {
    show();
    desk->toggle();
  });
  add_action(window, menu, "Record again with the next number", {QKeySequence("Ctrl+Shift+R")},
             [desk] { desk->again(); });
  add_action(window, menu, "Rename the chosen take…", {}, [panel, show] {
    show();
    panel->rows().rename();
  });
  QAction* keep = add_action(window, menu, "Keep everything on disk", {}, [&window, desk] {
    desk->keepEverything(!window.remembered().keepsEverything());
  });
  keep->setCheckable(true);
  keep->setChecked(window.remembered().keepsEverything());
  QObject::connect(panel, &TakePanel::everythingRequested, keep, &QAction::setChecked);
  menu->addSeparator();
  return *desk;
}

}  // namespace abrazo::app
