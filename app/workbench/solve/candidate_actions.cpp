#include <QAction>
#include <QMenu>
#include <QUndoCommand>

#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/library/take_list.hpp"

namespace abrazo::app {
namespace {

using widgets::CandidateTable;
using widgets::Reach;
using widgets::Steering;

void apply(MainWindow& window, const Steering& steering) {
  window.candidates().showSteering(steering);
  if (!window.session()) return;
  window.session()->push(PinPair{steering.pinned});
  window.session()->push(SetVetoes{steering.vetoes});
  window.session()->push(IntendMove{steering.meant});
}

/// From one whole value to another. Of no use once another library is open: its pairs are others.
class ChangeSteering : public QUndoCommand {
 public:
  ChangeSteering(MainWindow& window, Steering after, const QString& what)
      : QUndoCommand(what),
        m_window(window),
        m_library(window.candidates().library()),
        m_before(window.candidates().steering()),
        m_after(std::move(after)) {}

  void redo() override { change(m_after); }
  void undo() override { change(m_before); }

 private:
  void change(const Steering& steering) {
    const bool same = m_library.lock() == m_window.candidates().library();
    same ? apply(m_window, steering) : setObsolete(true);
  }

  MainWindow& m_window;
  std::weak_ptr<const MotionLibrary> m_library;
  Steering m_before, m_after;
};

/// The facts of a recorded frame in one line.
QString facts(const MotionLibrary& library, int take, int frame) {
  const LibraryTake& of = library.takes()[static_cast<std::size_t>(take)];
  QString words = QString("%1 · frame %2 of %3 · %4 s")
                      .arg(QString::fromStdString(of.name))
                      .arg(frame)
                      .arg(of.frames)
                      .arg(frame / of.fps, 0, 'f', 2);
  for (const LabelInterval& label : of.labels)
    if (label.start <= frame && frame < label.end)
      words +=
          QString(" · %1 %2–%3").arg(QString::fromStdString(label.label)).arg(label.start).arg(label.end);
  return words;
}

void connect_table(MainWindow& window) {
  CandidateTable& table = window.candidates();
  QObject::connect(&table, &CandidateTable::steeringRequested, &window,
                   [&window](const Steering& next, const QString& what) {
                     if (next != window.candidates().steering())
                       window.undoStack().push(new ChangeSteering(window, next, what));
                   });
  QObject::connect(&table, &CandidateTable::jumpRequested, &window, [&window](int take, int frame) {
    window.takes().setSelectedTake(take);
    window.messages().showInformation(facts(*window.candidates().library(), take, frame));
  });
  // The next session on the same library goes on with what was decided.
  QObject::connect(&window, &MainWindow::sessionStarted, &window, [&window] {
    if (!window.candidates().steering().empty()) apply(window, window.candidates().steering());
  });
}

}  // namespace

void add_candidate_actions(MainWindow& window) {
  connect_table(window);
  CandidateTable& table = window.candidates();
  QMenu* menu = window.menu("Solve");
  menu->addSeparator();
  add_action(window, menu, "Use this candidate, or unpin it", {QKeySequence("P")},
             [&table] { table.togglePin(); });
  add_action(window, menu, "Veto this candidate", {QKeySequence("V")},
             [&table] { table.toggleVeto(Reach::Pair); });
  add_action(window, menu, "Veto its take", {QKeySequence("Shift+V")},
             [&table] { table.toggleVeto(Reach::Take); });
  add_action(window, menu, "Veto its move", {QKeySequence("Alt+V")},
             [&table] { table.toggleVeto(Reach::Label); });
  add_action(window, menu, "Clear pin and vetoes", {QKeySequence("Shift+P")}, [&table] { table.liftAll(); });
  add_action(window, menu, "Go to its take and frame", {}, [&table] { table.jump(); });
  add_action(window, menu, "Choose among the candidates", {QKeySequence("Alt+C")},
             [&table] { table.setFocus(Qt::TabFocusReason); });
}

}  // namespace abrazo::app
