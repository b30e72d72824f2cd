#include "app/workbench/labels/suggestion_desk.hpp"

#include <QAction>
#include <QListWidget>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/job.hpp"
#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "widgets/annotation/annotation_panel.hpp"
#include "widgets/annotation/suggestion_section.hpp"
#include "widgets/annotation/value_picker.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app {
namespace {

using widgets::SuggestionSection;

using widgets::text;

}  // namespace

SuggestionDesk::SuggestionDesk(MainWindow& window, AnnotationDesk& annotations)
    : QObject(&window),
      m_window(window),
      m_document(window.document()),
      m_annotations(annotations),
      m_section(new SuggestionSection) {
  window.colour(m_section);
  annotations.panel().addSection(m_section);
  connect(&m_document, &Document::ending, this, &SuggestionDesk::cancel);
  connect(&m_document, &Document::changed, this, [this](ProjectPart part) {
    if (part == ProjectPart::Annotations) m_section->showSuggestions(m_document.annotations());
  });
  connect(&m_document, &Document::annotationsReplaced, this, [this] {
    cancel();
    m_section->showSuggestions(m_document.annotations());
  });
  connect(m_section, &SuggestionSection::suggestRequested, this, &SuggestionDesk::suggest);
  connect(m_section, &SuggestionSection::cancelRequested, this, &SuggestionDesk::cancel);
  connect(m_section, &SuggestionSection::acceptRequested, this, &SuggestionDesk::accept);
  connect(m_section, &SuggestionSection::editRequested, this, &SuggestionDesk::edit);
  connect(m_section, &SuggestionSection::rejectRequested, this, &SuggestionDesk::reject);
  connect(m_section, &SuggestionSection::acceptAllRequested, this, &SuggestionDesk::acceptAll);
  connect(m_section, &SuggestionSection::chosen, this, [this](int suggestion, double start_s) {
    m_window.timeline().showChosenSuggestion(suggestion);
    m_window.ticker().seek(start_s);
  });
  connect(&window.timeline(), &widgets::TimelineView::suggestionChosen, m_section,
          &SuggestionSection::choose);
  connect(&window.timeline(), &widgets::TimelineView::suggestionEntryRequested, this, &SuggestionDesk::edit);
  connect(m_section, &SuggestionSection::clearRequested, this,
          [this] { m_document.edit(clear_suggestions(m_document.annotations())); });
}

SuggestionDesk::~SuggestionDesk() = default;

void SuggestionDesk::suggest(bool moves, bool roles) {
  const SuggestionRequest request{m_document.subject(), moves, roles};
  const auto library = m_annotations.library();
  if (m_job) return m_window.messages().showInformation("Suggestions are being made already");
  if (!library || request.take.empty())
    return m_window.messages().showInformation(
        "Suggestions are made for a take of the library: choose one with Annotation > Annotate take");
  m_window.panels().want("annotation", true);
  m_job = std::make_unique<Job>([this, library, request](const Progress& progress) -> Job::Finish {
    auto suggested = suggest_annotations(*library, request, progress);
    if (!suggested) return [this, why = words(suggested.error())] { m_window.messages().showError(why); };
    return [this, request, suggested = std::move(*suggested)] { take(request, suggested); };
  });
  m_section->showProgress(0, "Suggesting");
  connect(m_job.get(), &Job::progressed, m_section, &SuggestionSection::showProgress);
  connect(m_job.get(), &Job::finished, this, &SuggestionDesk::cancel);
}

void SuggestionDesk::cancel() {
  Job::retire(std::move(m_job), this);
  m_section->showProgress(-1, {});
}

void SuggestionDesk::take(const SuggestionRequest& request, const SuggestedTiers& suggested) {
  if (request.take != m_document.subject()) return;
  if (!m_document.edit(with_suggestions(m_document.annotations(), suggested, request))) return;
  focusList();
  const auto count =
      (request.moves ? suggested.moves.size() : 0) + (request.roles ? suggested.roles.size() : 0);
  const auto key = [this](const char* id) {
    const QAction* action = action_of(m_window, id);
    return action ? action->shortcut().toString(QKeySequence::NativeText) : QString();
  };
  m_window.messages().showInformation(
      QString("%1 suggestions: %2 accepts, %3 accepts with another value, %4 rejects")
          .arg(count)
          .arg(key("annotation.accept_suggestion"), key("annotation.accept_suggestion_as"),
               key("annotation.reject_suggestion")));
}

void SuggestionDesk::focusList() {
  m_window.panels().want("annotation", true);
  m_section->list().setFocus(Qt::OtherFocusReason);
}

void SuggestionDesk::acceptCurrent() {
  if (const int id = m_section->current(); id != 0) accept(id);
}
void SuggestionDesk::editCurrent() {
  if (const int id = m_section->current(); id != 0) edit(id);
}
void SuggestionDesk::rejectCurrent() {
  if (const int id = m_section->current(); id != 0) reject(id);
}

void SuggestionDesk::accept(int suggestion) {
  m_document.edit(accept_suggestion(m_document.annotations(), m_annotations.place(), suggestion));
}

void SuggestionDesk::acceptAll(const std::vector<int>& suggestions) {
  const auto accepted = accept_suggestions(m_document.annotations(), m_annotations.place(), suggestions);
  m_document.edit(accepted.edit);
  if (accepted.refused > 0)
    m_window.messages().showInformation(QString("%1 accepted; %2 stay suggestions: %3")
                                            .arg(suggestions.size() - accepted.refused)
                                            .arg(accepted.refused)
                                            .arg(text(accepted.why)));
}

void SuggestionDesk::edit(int suggestion) {
  const Suggestion* asked = m_document.annotations().find_suggestion(suggestion);
  const AnnotationTier* tier = asked ? m_document.annotations().tier(asked->tier) : nullptr;
  if (!tier) return;
  const widgets::ValuePicker::Question question{*tier,
                                                QString("instead of %1, from %2 s to %3 s")
                                                    .arg(text(asked->value))
                                                    .arg(asked->start_s, 0, 'f', 2)
                                                    .arg(asked->end_s, 0, 'f', 2),
                                                text(asked->value)};
  widgets::ValuePicker::open(*m_section, QPoint(8, m_section->list().y()), question, m_window.colours(),
                             [this, suggestion](const QString& value) -> QString {
                               const auto accepted =
                                   accept_suggestion_as(m_document.annotations(), m_annotations.place(),
                                                        suggestion, value.toStdString());
                               if (!accepted) return words(accepted.error());
                               m_document.edit(accepted);
                               return {};
                             });
}

void SuggestionDesk::reject(int suggestion) {
  m_document.edit(reject_suggestion(m_document.annotations(), suggestion));
}

}  // namespace abrazo::app
