#include <QMenu>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/labels/label_questions.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app {
namespace {

/// The next or previous label of the active tier is selected and gone to.
void step(MainWindow& window, AnnotationDesk& desk, int by) {
  const auto label = label_beside(window.document().annotations(), desk.place(), by);
  if (!label) return window.messages().showInformation(words(label.error()));
  window.document().selectLabel(label->id);
  window.ticker().seek(label->start_s);
}

/// The chosen label between in and out, played round and round.
void loop(MainWindow& window, AnnotationDesk& desk) {
  const auto label = chosen_label(window.document().annotations(), desk.place());
  if (!label) return window.messages().showInformation(words(label.error()));
  FrameTicker& ticker = window.ticker();
  ticker.setRange(label->start_s, label->end_s);
  ticker.setLoop(true);
  ticker.seek(label->start_s);
  if (ticker.playback().state != Playback::State::Playing) ticker.toggle();
}

/// @param frames  of the subject, or of the input where the subject has no fixed rate
void nudge(MainWindow& window, AnnotationDesk& desk, LabelEdge edge, int frames) {
  const double input_hz = window.transport().rate();
  const double rate_hz = desk.fps() > 0 ? desk.fps() : input_hz > 0 ? input_hz : 60;
  Document& document = window.document();
  document.edit(nudge_label(document.annotations(), desk.place(), edge, frames / rate_hz));
}

void add_nudges(MainWindow& window, AnnotationDesk& desk, QMenu* menu) {
  QMenu* nudges = menu->addMenu("Nudge label");
  const std::tuple<const char*, const char*, LabelEdge, int> ways[] = {
      {"Label a frame earlier", "Ctrl+Alt+Left", LabelEdge::Both, -1},
      {"Label a frame later", "Ctrl+Alt+Right", LabelEdge::Both, 1},
      {"Start of label a frame earlier", "Ctrl+Shift+Left", LabelEdge::Start, -1},
      {"Start of label a frame later", "Ctrl+Shift+Right", LabelEdge::Start, 1},
      {"End of label a frame earlier", "Alt+Shift+Left", LabelEdge::End, -1},
      {"End of label a frame later", "Alt+Shift+Right", LabelEdge::End, 1}};
  for (const auto& [name, key, edge, by] : ways)
    add_action(window, nudges, name, {QKeySequence(key)},
               [&window, &desk, edge = edge, by = by] { nudge(window, desk, edge, by); });
}

}  // namespace

void add_label_actions(MainWindow& window, AnnotationDesk& desk, LabelQuestions& questions) {
  QMenu* menu = menu_of(window, "Annotation");
  Document& document = window.document();
  using Edit = Result<LabelEdit> (*)(const Annotations&, const EditPlace&);
  const auto add_edit = [&](const char* name, const char* key, Edit edit) {
    add_action(window, menu, name, {QKeySequence(key)},
               [&document, &desk, edit] { document.edit(edit(document.annotations(), desk.place())); });
  };
  add_action(window, menu, "New label…", {QKeySequence("N")}, [&questions] { questions.draw(); });
  add_action(window, menu, "Edit label…", {QKeySequence("F2")}, [&questions] { questions.ask(); });
  add_edit("Extend label to the cursor", "E", extend_label);
  add_edit("Split label at the cursor", "S", split_label);
  add_edit("Merge label with the next", "Shift+S", merge_label);
  add_edit("Change of role here", "Shift+U", change_role);
  menu->addSeparator();
  add_action(window, menu, "Previous label", {QKeySequence("Ctrl+Up")},
             [&window, &desk] { step(window, desk, -1); });
  add_action(window, menu, "Next label", {QKeySequence("Ctrl+Down")},
             [&window, &desk] { step(window, desk, 1); });
  add_action(window, menu, "Loop the label", {QKeySequence("Alt+L")},
             [&window, &desk] { loop(window, desk); });
  add_nudges(window, desk, menu);
  QMenu* copy = menu->addMenu("Copy label to the tier");
  QObject::connect(copy, &QMenu::aboutToShow, &questions, [&questions, copy] {
    copy->clear();
    questions.fillMenu(*copy);
  });
}

}  // namespace abrazo::app
