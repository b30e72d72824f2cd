#include <QAction>
#include <QDialog>
#include <QMenu>
#include <QPointer>
#include <QVBoxLayout>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/file_dialogs.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "core/base/atomic_file.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/selection_model.hpp"
#include "widgets/plots/plot_panel.hpp"
#include "widgets/scene/panel/scene_tree.hpp"
#include "widgets/scene/pick/part_table_view.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app {
namespace {

using widgets::CandidateTable;
using widgets::PartTableView;
using widgets::PlotPanel;
using widgets::SceneOptions;
using widgets::SceneTree;
using widgets::SceneView;
using widgets::Selection;
using widgets::SelectionModel;

/// Every view requests changes of the shared selection and shows it.
void link_views(MainWindow& window) {
  SelectionModel& model = window.selection();
  SceneView& scene = window.scene();
  SceneTree& tree = window.sceneTree();
  CandidateTable& candidates = window.candidates();
  PlotPanel& plots = window.plots();
  QObject::connect(&scene, &SceneView::selectionRequested, &model, &SelectionModel::select);
  QObject::connect(&tree, &SceneTree::selectionRequested, &model, &SelectionModel::select);
  QObject::connect(&candidates, &CandidateTable::selectionRequested, &model, &SelectionModel::select);
  QObject::connect(&plots, &PlotPanel::selectionRequested, &model, &SelectionModel::select);
  QObject::connect(&model, &SelectionModel::selectionChanged, &scene, &SceneView::showSelection);
  QObject::connect(&model, &SelectionModel::selectionChanged, &tree, &SceneTree::showSelection);
  QObject::connect(&model, &SelectionModel::selectionChanged, &candidates, &CandidateTable::showSelection);
  QObject::connect(&model, &SelectionModel::selectionChanged, &plots, &PlotPanel::showSelection);
  QObject::connect(&scene, &SceneView::candidateHovered, &candidates, &CandidateTable::pointAt);
  QObject::connect(&window.ticker(), &FrameTicker::panelsDue, &scene, [&window] {
    if (const FrameHistory* history = window.ticker().history()) window.scene().showPast(*history);
  });
  // A pair is a number of its library: it means another one, or none, in the next.
  QObject::connect(&window.document(), &Document::began, &model, [&model] {
    if (model.selection().kind == widgets::SelectionKind::Candidate) model.select({});
  });
}

void export_table(MainWindow& window, const PartTableView& view) {
  const QString file = ask_new_file(&window, window.remembered(), "Export the table", "selection.csv", ".csv",
                                    "CSV (*.csv);;All files (*)");
  if (file.isEmpty()) return;
  const Status written = write_whole_file(file.toStdString(), csv_of(view.shown()));
  written ? window.messages().succeed("table", "The table was written to " + file)
          : window.messages().showErrorOf("table", words(written.error()));
}

/// The table goes with the shown frame and the selection while its window is open.
void show_table(MainWindow& window, QPointer<QDialog>& dialog) {
  if (dialog) return dialog->raise();
  dialog = new QDialog(&window);
  dialog->setObjectName("selection table");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle("Figures of the selection");
  dialog->resize(760, 420);
  auto* column = new QVBoxLayout(dialog);
  auto* view = new PartTableView(dialog);
  column->addWidget(view);
  const auto show_frame = [&window, view] {
    const FrameSnapshotPtr& frame = window.ticker().shown();
    const FrameHistory* history = window.ticker().history();
    // The frame before may have to be read from disk.
    if (frame && view->isDue(frame))
      view->showFrame(frame, history ? history->stepped(frame->time_s, -1) : nullptr);
  };
  QObject::connect(&window.ticker(), &FrameTicker::frameReady, view, show_frame);
  QObject::connect(&window.selection(), &SelectionModel::selectionChanged, view,
                   &PartTableView::showSelection);
  QObject::connect(view, &PartTableView::selectionRequested, &window.selection(), &SelectionModel::select);
  QObject::connect(view, &PartTableView::csvRequested, view,
                   [&window, view] { export_table(window, *view); });
  view->showSelection(window.selection().selection());
  if (window.selection().selection().kind == widgets::SelectionKind::Joints)
    view->setKind(widgets::TableOf::Joints);
  if (window.selection().selection().kind == widgets::SelectionKind::Tetrahedron)
    view->setKind(widgets::TableOf::Tetrahedra);
  show_frame();
  dialog->show();
}

}  // namespace

void add_selection_actions(MainWindow& window) {
  link_views(window);
  menu_of(window, "View")->addSeparator();
  QMenu* menu = menu_of(window, "View")->addMenu("Selection");
  SceneView& scene = window.scene();
  SelectionModel& model = window.selection();
  QAction* isolate = add_action(window, menu, "Isolate the selection", {QKeySequence("X")}, [] {});
  isolate->setCheckable(true);
  QObject::connect(isolate, &QAction::toggled, &scene, [&scene](bool on) {
    SceneOptions options = scene.options();
    options.isolates = on;
    scene.setOptions(options);
  });
  QObject::connect(&scene, &SceneView::optionsChanged, isolate,
                   [isolate](const SceneOptions& options) { isolate->setChecked(options.isolates); });
  add_action(window, menu, "Hide the selection", {QKeySequence("H")}, [&scene] { scene.hideSelection(); });
  add_action(window, menu, "Show hidden parts", {QKeySequence("Alt+H")}, [&scene] { scene.showHidden(); });
  add_action(window, menu, "Same part of the other character", {QKeySequence("`")},
             [&model] { model.select(widgets::other_character(model.selection())); });
  add_action(window, menu, "Figures of the selection…", {},
             [&window, dialog = QPointer<QDialog>()]() mutable { show_table(window, dialog); });
  QAction* nothing =
      add_action(window, menu, "Select nothing", {QKeySequence("Esc")}, [&model] { model.select({}); });
  // Only if the scene has the focus: fields and lists handle Escape themselves.
  nothing->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  window.removeAction(nothing);
  scene.addAction(nothing);
}

}  // namespace abrazo::app
