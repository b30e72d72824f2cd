#include "app/workbench/labels/label_questions.hpp"

#include <QMenu>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/annotation/value_picker.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/common/value_look.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app {
namespace {

using widgets::text;
using widgets::TimelineView;

constexpr int lane_px = static_cast<int>(widgets::TimelineLanes::tier_px);

}  // namespace

LabelQuestions::LabelQuestions(MainWindow& window, AnnotationDesk& desk)
    : QObject(&desk), m_window(window), m_document(window.document()), m_desk(desk) {
  const TimelineView& timeline = window.timeline();
  connect(&timeline, &TimelineView::labelDrawn, this, &LabelQuestions::askValue);
  connect(&timeline, &TimelineView::valueEntryRequested, this, [this](int annotation) {
    m_document.selectLabel(annotation);
    ask();
  });
  connect(&timeline, &TimelineView::tierMenuRequested, this, &LabelQuestions::openMenu);
}

void LabelQuestions::draw() {
  const auto span = span_at(m_document.annotations(), m_desk.place());
  span ? askValue(m_document.labels().tier(), span->first_s, span->last_s)
       : m_window.messages().showInformation(words(span.error()));
}

/// The interval exists only once it has a value.
void LabelQuestions::askValue(int tier, double from_s, double to_s) {
  const AnnotationTier* of = m_document.annotations().tier(tier);
  if (!of) return;
  const Annotations::Range span{from_s, to_s};
  openPicker(*of, span, m_window.timeline().placeOf(tier, to_s) + QPoint(4, lane_px), text(m_used[tier]),
             [this, tier, span](const std::string& value) {
               return draw_label(m_document.annotations(), m_desk.place(), tier, span, value);
             });
}

void LabelQuestions::ask() {
  const auto label = chosen_label(m_document.annotations(), m_desk.place());
  if (!label) return m_window.messages().showInformation(words(label.error()));
  const AnnotationTier& tier = *m_document.annotations().tier_of(label->id);
  openPicker(tier, {label->start_s, label->end_s},
             m_window.timeline().placeOf(tier.id, label->start_s) + QPoint(0, lane_px), text(label->value),
             [this, id = label->id](const std::string& value) {
               return say_label(m_document.annotations(), id, value);
             });
}

void LabelQuestions::openPicker(const AnnotationTier& tier, const Annotations::Range& span,
                                const QPoint& place, const QString& value,
                                std::function<Result<LabelEdit>(const std::string&)> edit) {
  const QString title =
      QString("%1, %2 to %3 s").arg(text(tier.name)).arg(span.first_s, 0, 'f', 2).arg(span.last_s, 0, 'f', 2);
  widgets::ValuePicker::open(m_window.timeline(), place, {tier, title, value}, m_window.colours(),
                             [this, tier = tier.id, edit = std::move(edit)](const QString& said) -> QString {
                               const auto edited = edit(said.toStdString());
                               if (!edited) return words(edited.error());
                               m_used[tier] = said.toStdString();
                               m_document.edit(edited);
                               return {};
                             });
}

void LabelQuestions::fillMenu(QMenu& menu) {
  QMenu* copy = menu.addMenu("Copy to");
  for (const AnnotationTier& tier : m_document.annotations().tiers())
    if (tier.id != m_document.labels().tier())
      copy->addAction(text(tier.name), this, [this, id = tier.id] {
        m_document.edit(copy_label(m_document.annotations(), m_desk.place(), id));
      });
  copy->setEnabled(!copy->isEmpty());
}

void LabelQuestions::openMenu(int tier, int annotation, double time_s, const QPoint& global) {
  QMenu menu(&m_window);
  const auto add = [&](const char* id) {
    if (QAction* action = action_of(m_window, id)) menu.addAction(action);
  };
  if (annotation == 0) {
    menu.addAction("New label here…", this, [this, tier, time_s] {
      m_window.ticker().seek(time_s);
      m_document.chooseTier(tier);
      draw();
    });
    add("annotation.change_of_role_here");
    menu.exec(global);
    return;
  }
  if (const AnnotationTier* of = m_document.annotations().tier(tier))
    for (const VocabularyEntry& entry : of->vocabulary) {
      QString said = widgets::value_words(*of, entry.value);
      if (entry.key != 0) said += "\t" + QString(QChar(entry.key)).toUpper();
      menu.addAction(said, this, [this, annotation, value = entry.value] {
        m_document.edit(say_label(m_document.annotations(), annotation, value));
      });
    }
  menu.addSeparator();
  for (const char* id : {"annotation.edit_label", "annotation.split_label_at_the_cursor",
                         "annotation.merge_label_with_the_next", "annotation.extend_label_to_the_cursor"})
    add(id);
  fillMenu(menu);
  menu.addSeparator();
  add("timeline.delete_label_or_marker");
  menu.exec(global);
}

}  // namespace abrazo::app
