#include <QAction>
#include <QMenu>

#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/library/take_list.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app {
namespace {

using widgets::CandidateTable;

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
      words += QString(" · %1 %2–%3")
                   .arg(QString::fromStdString(label.label).replace('_', ' '))
                   .arg(label.start)
                   .arg(label.end);
  return words;
}

void connect_table(MainWindow& window) {
  CandidateTable& table = window.candidates();
  QObject::connect(&table, &CandidateTable::jumpRequested, &window, [&window](int take, int frame) {
    window.takes().setSelectedTake(take);
    window.messages().showInformation(facts(*window.session()->material().library, take, frame));
  });
}

/// Takes the pin of the live partner away; the parked frame keeps what is tried on it.
void lift_live_pin(Document& document) {
  Decisions next = document.decisions();
  next.pinned.reset();
  document.change(next, "lift the live pin");
}

void use_tried(Document& document) {
  document.useTriedSettings();
  document.useTriedPin();
}

}  // namespace

void add_candidate_actions(MainWindow& window) {
  connect_table(window);
  CandidateTable& table = window.candidates();
  QMenu* menu = menu_of(window, "Solve");
  menu->addSeparator();
  add_action(window, menu, "Use this candidate, or unpin it", {QKeySequence("P")},
             [&table] { table.togglePin(); });
  Document& document = window.document();
  add_action(window, menu, "Lift the pin of the live partner", {}, [&document] { lift_live_pin(document); });
  add_action(window, menu, "Use what was tried here for the live partner", {},
             [&document] { use_tried(document); });
  QObject::connect(&document, &Document::triedTakenBack, &window, [&window] {
    window.messages().showInformation(
        "The settings that you tried on an older frame were taken back: the live partner did not have them. "
        "Undo (Ctrl+Z) gives them to it");
  });
  widgets::TransportBar& transport = window.transport();
  QObject::connect(&transport, &widgets::TransportBar::liftPinRequested, &document,
                   [&document] { lift_live_pin(document); });
  QObject::connect(&transport, &widgets::TransportBar::useTriedRequested, &document,
                   [&document] { use_tried(document); });
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
