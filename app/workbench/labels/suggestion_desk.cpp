#include "app/workbench/labels/suggestion_desk.hpp"

#include <QListWidget>
#include <algorithm>

#include "app/workbench/base/job.hpp"
#include "app/workbench/labels/annotation_desk.hpp"
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

/// The tier that suggestions of a kind go to; made when there is none.
Result<int> tier_for(Annotations& annotations, TierKind kind) {
  if (const AnnotationTier* tier = annotations.first_of(kind)) return tier->id;
  return annotations.add_tier(kind == TierKind::Role ? "role" : "move", kind, {});
}

}  // namespace

SuggestionDesk::SuggestionDesk(MainWindow& window, AnnotationDesk& annotations)
    : QObject(&window), m_window(window), m_annotations(annotations), m_section(new SuggestionSection) {
  m_section->setColours(window.colours());
  annotations.panel().addSection(m_section);
  connect(&window, &MainWindow::coloursChanged, m_section, &SuggestionSection::setColours);
  connect(&window, &MainWindow::sessionEnding, this, [this] { cancel(); });
  connect(&annotations, &AnnotationDesk::annotationsChanged, this,
          [this] { m_section->showSuggestions(m_annotations.annotations()); });
  connect(&annotations, &AnnotationDesk::subjectChanged, this, &SuggestionDesk::cancel);
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
  connect(m_section, &SuggestionSection::clearRequested, this, [this] {
    Annotations next = m_annotations.annotations();
    next.clear_suggestions();
    m_annotations.change(std::move(next), "clear suggestions");
  });
}

SuggestionDesk::~SuggestionDesk() = default;

void SuggestionDesk::suggest(bool moves, bool roles) {
  const std::string subject = m_annotations.subject();
  const auto library = m_annotations.library();
  if (m_job) return m_window.messages().showInformation("Suggestions are being made already");
  if (!library || subject.empty())
    return m_window.messages().showInformation(
        "Suggestions are made for a take of the library: choose one with Annotation > Annotate take");
  m_window.panels().want("annotation", true);
  m_job =
      std::make_unique<Job>([this, library, subject, moves, roles](const Progress& progress) -> Job::Finish {
        auto suggested =
            suggest_annotations(*library, {.take = subject, .moves = moves, .roles = roles}, progress);
        if (!suggested)
          return [this, why = text(suggested.error().text())] { m_window.messages().showError(why); };
        return [this, subject, moves, roles, suggested = std::move(*suggested)] {
          take(subject, suggested, moves, roles);
        };
      });
  m_section->showProgress(0, "Suggesting");
  connect(m_job.get(), &Job::progressed, m_section, &SuggestionSection::showProgress);
  connect(m_job.get(), &Job::finished, this, &SuggestionDesk::finish);
}

void SuggestionDesk::cancel() {
  Job::retire(std::move(m_job), this);
  m_section->showProgress(-1, {});
}

void SuggestionDesk::finish() {
  if (m_job) m_job.release()->deleteLater();  // it is what speaks
  m_section->showProgress(-1, {});
}

void SuggestionDesk::take(const std::string& subject, SuggestedTiers suggested, bool moves, bool roles) {
  if (subject != m_annotations.subject()) return;
  Annotations next = m_annotations.annotations();
  std::vector<int> tiers;
  std::vector<Suggestion> all;
  const auto add = [&](TierKind kind, std::vector<Suggestion>& list) {
    const auto tier = tier_for(next, kind);
    if (!tier) return;
    tiers.push_back(*tier);
    for (Suggestion& one : list) one.tier = *tier;
    all.insert(all.end(), list.begin(), list.end());
  };
  if (moves) add(TierKind::Move, suggested.moves);
  if (roles) add(TierKind::Role, suggested.roles);
  if (all.empty())
    return m_window.messages().showInformation(moves ? "The other takes have no labels to learn from"
                                                     : "The other takes do not say who is active");
  const auto count = all.size();
  next.suggest(tiers, std::move(all));
  m_annotations.change(std::move(next), moves ? "suggest labels" : "suggest roles");
  focusList();
  m_window.messages().showInformation(
      QString("%1 suggestions: A accepts, E accepts with another value, X rejects").arg(count));
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
  Annotations next = m_annotations.annotations();
  const auto done = next.accept(suggestion, m_annotations.conflict(), m_annotations.range());
  m_annotations.changeOrTell(done ? Status(Done{}) : Status(done.error()), std::move(next),
                             "accept suggestion");
}

void SuggestionDesk::acceptAll(const std::vector<int>& suggestions) {
  Annotations next = m_annotations.annotations();
  int accepted = 0;
  std::string why;
  for (const int id : suggestions) {
    Annotations tried = next;
    const auto done = tried.accept(id, m_annotations.conflict(), m_annotations.range());
    if (done) {
      next = std::move(tried);
      ++accepted;
    } else {
      why = done.error().text();
    }
  }
  m_annotations.change(std::move(next), QString("accept %1 suggestions").arg(accepted));
  const auto refused = static_cast<int>(suggestions.size()) - accepted;
  if (refused > 0)
    m_window.messages().showInformation(
        QString("%1 accepted; %2 stay suggestions: %3").arg(accepted).arg(refused).arg(text(why)));
}

void SuggestionDesk::edit(int suggestion) {
  const Suggestion* asked = m_annotations.annotations().find_suggestion(suggestion);
  const AnnotationTier* tier = asked ? m_annotations.annotations().tier(asked->tier) : nullptr;
  if (!tier) return;
  const widgets::ValuePicker::Question question{*tier,
                                                QString("instead of %1, from %2 s to %3 s")
                                                    .arg(text(asked->value))
                                                    .arg(asked->start_s, 0, 'f', 2)
                                                    .arg(asked->end_s, 0, 'f', 2),
                                                text(asked->value)};
  widgets::ValuePicker::open(*m_section, QPoint(8, m_section->list().y()), question, m_window.colours(),
                             [this, suggestion](const QString& value) -> QString {
                               Annotations next = m_annotations.annotations();
                               const auto id =
                                   next.accept(suggestion, m_annotations.conflict(), m_annotations.range());
                               if (!id) return text(id.error().text());
                               const Status said = next.say(*id, value.toStdString(), "", "");
                               if (!said) return text(said.error().text());
                               m_annotations.change(std::move(next), "accept suggestion as " + value);
                               return {};
                             });
}

void SuggestionDesk::reject(int suggestion) {
  Annotations next = m_annotations.annotations();
  const Status done = next.reject(suggestion);
  m_annotations.changeOrTell(done, std::move(next), "reject suggestion");
}

}  // namespace abrazo::app
