#include <QAction>
#include <QActionGroup>
#include <QMenu>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/labels/label_import.hpp"
#include "app/workbench/labels/label_key_filter.hpp"
#include "app/workbench/labels/label_questions.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/annotation/annotation_panel.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/library/take_list.hpp"
#include "widgets/timeline/quick_entry.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app {
namespace {

using widgets::text;

/// -1 when no take of the library does.
int take_that_plays_the_user(const Material& material) {
  return material.reading.file.empty() ? material.library->find_take(material.input.name) : -1;
}

/// @param take  -1 = the one chosen in the library, else the one that plays the user
void annotate_take(MainWindow& window, AnnotationDesk& desk, int take) {
  const auto library = desk.library();
  if (!library) return window.messages().showInformation("Nothing is open yet");
  if (take < 0) take = window.takes().selectedTake();
  if (take < 0) take = take_that_plays_the_user(window.session()->material());
  if (take < 0 || take >= static_cast<int>(library->takes().size()))
    return window.messages().showInformation("Choose a take in the library first; no take plays the user");
  desk.showSubject(library->takes()[static_cast<std::size_t>(take)].name);
}

void add_subjects(MainWindow& window, QMenu* menu, AnnotationDesk& desk) {
  add_action(window, menu, "Annotate take", {QKeySequence("Ctrl+E")},
             [&window, &desk] { annotate_take(window, desk, -1); });
  QAction* back = add_action(window, menu, "Back to the session", {QKeySequence("Ctrl+Shift+E")},
                             [&desk] { desk.showSubject({}); });
  back->setEnabled(false);
  const Document& document = window.document();
  QObject::connect(&document, &Document::annotationsReplaced, back,
                   [back, &document] { back->setEnabled(!document.subject().empty()); });
  QObject::connect(&window.takes(), &widgets::TakeList::annotateRequested, &desk,
                   [&window, &desk](int take) { annotate_take(window, desk, take); });
}

void add_conflicts(MainWindow& window, QMenu* menu) {
  Document& document = window.document();
  auto* group = new QActionGroup(menu);
  const std::pair<const char*, Conflict> ways[] = {{"Overlapping labels: trim", Conflict::Replace},
                                                   {"Overlapping labels: push", Conflict::Push},
                                                   {"Overlapping labels: refuse", Conflict::Refuse}};
  for (const auto& [name, way] : ways) {
    QAction* action =
        add_action(window, menu, name, {}, [&document, way = way] { document.setConflict(way); });
    action->setCheckable(true);
    group->addAction(action);
    const auto show = [action, &document, way = way] {
      action->setChecked(document.labels().conflict() == way);
    };
    QObject::connect(&document, &Document::labelChosen, action, show);
    show();
  }
}

void name_tier(MainWindow& window, bool is_new) {
  Document& document = window.document();
  const AnnotationTier* tier = document.annotations().tier(document.labels().tier());
  if (!window.session() || (!is_new && !tier))
    return window.messages().showInformation("Nothing is open, or it has no tier yet");
  const auto take = [&document, is_new](const QString& name) -> QString {
    const auto edit = is_new
                          ? new_tier(document.annotations(), name.toStdString())
                          : rename_tier(document.annotations(), document.labels().tier(), name.toStdString());
    if (!edit) return words(edit.error());
    document.edit(edit);
    return {};
  };
  widgets::QuickEntry::open(window.timeline(), QPoint(20, 0),
                            is_new ? "Name of the new tier, for notes in free text" : "Name of the tier",
                            is_new ? QString() : text(tier->name), take);
}

void choose_beside(Document& document, int by) {
  document.chooseTier(tier_beside(document.annotations(), document.labels().tier(), by));
}

void add_tiers(MainWindow& window, QMenu* menu) {
  Document& document = window.document();
  add_action(window, menu, "Tier above", {QKeySequence("Ctrl+Alt+Up")},
             [&document] { choose_beside(document, -1); });
  add_action(window, menu, "Tier below", {QKeySequence("Ctrl+Alt+Down")},
             [&document] { choose_beside(document, 1); });
  add_action(window, menu, "New tier…", {}, [&window] { name_tier(window, true); });
  add_action(window, menu, "Rename tier…", {}, [&window] { name_tier(window, false); });
  add_action(window, menu, "Delete tier", {},
             [&document] { document.edit(delete_tier(document.annotations(), document.labels().tier())); });
  add_action(window, menu, "Show or hide the tier's lane", {}, [&window, &document] {
    const AnnotationTier* tier = document.annotations().tier(document.labels().tier());
    if (!tier) return;
    widgets::TimelineLanes lanes = window.timeline().lanes();
    lanes.set_tier_shown(tier->name, !lanes.is_shown(widgets::TierLane{tier->id, tier->name}));
    window.timeline().setLanes(lanes);
  });
}

}  // namespace

void add_annotation_actions(MainWindow& window, AnnotationDesk& desk, LabelKeyFilter& keys) {
  auto* questions = new LabelQuestions(window, desk);
  QMenu* menu = menu_of(window, "Annotation");
  add_subjects(window, menu, desk);
  menu->addSeparator();
  add_label_actions(window, desk, *questions);
  menu->addSeparator();
  QAction* taps =
      add_action(window, menu, "Tap mode: each key starts the next label", {QKeySequence("Shift+T")}, [] {});
  taps->setCheckable(true);
  QObject::connect(taps, &QAction::toggled, &keys, &LabelKeyFilter::setTaps);
  menu->addSeparator();
  add_conflicts(window, menu);
  menu->addSeparator();
  add_tiers(window, menu);
  menu->addSeparator();
  auto* import = new LabelImport(window, desk);
  add_action(window, menu, "Import labels…", {}, [import] { import->choose(); });
  QObject::connect(&desk.panel(), &widgets::AnnotationPanel::importRequested, import, &LabelImport::choose);
  QObject::connect(&desk.panel(), &widgets::AnnotationPanel::exportRequested, &desk, [&window] {
    if (QAction* action = action_of(window, "annotation.export_labels")) action->trigger();
  });
  add_suggestion_actions(window, desk);
}

}  // namespace abrazo::app
