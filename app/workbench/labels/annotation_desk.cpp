#include "app/workbench/labels/annotation_desk.hpp"

#include <QUndoCommand>
#include <algorithm>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/document/library_feed.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "app/workbench/shell/subject_stage.hpp"
#include "core/opening/material.hpp"
#include "widgets/annotation/annotation_panel.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app {
namespace {

using widgets::AnnotationPanel;
using widgets::text;
using widgets::TimelineView;

constexpr const char* panel_id = "annotation";

}  // namespace

/// Of no use once another session or project is open.
class AnnotationCommand : public QUndoCommand {
 public:
  AnnotationCommand(AnnotationDesk& desk, AnnotationStep step)
      : QUndoCommand(widgets::text(step.what)), m_desk(desk), m_step(std::move(step)) {}

  void redo() override { setObsolete(!m_desk.apply(m_step, AnnotationState::Direction::Do)); }
  void undo() override { setObsolete(!m_desk.apply(m_step, AnnotationState::Direction::Undo)); }

 private:
  AnnotationDesk& m_desk;
  AnnotationStep m_step;
};

AnnotationDesk::AnnotationDesk(MainWindow& window)
    : QObject(&window),
      m_window(window),
      m_panel(new AnnotationPanel),
      m_feed(new LibraryFeed(window.document(), this)),
      m_stage(std::make_unique<SubjectStage>(window)) {
  window.colour(m_panel);
  window.addPanel(panel_id, "Annotation", m_panel, Qt::RightDockWidgetArea, false);
  connect(&window.document(), &Document::began, this, &AnnotationDesk::onSessionStarted);
  connect(&window.document(), &Document::ending, this, [this] {
    m_feed->forget();
    m_stage->forget();
  });
  connect(m_feed, &LibraryFeed::failed, &window.messages(), &widgets::MessageBar::showError);
  connect(&window.document(), &Document::libraryReplaced, this, [this] {
    if (showsTake()) m_stage->renew();
  });
  connect(&window.document(), &Document::subjectChanged, this, [this] {
    if (const auto of = library()) m_state.show(m_window.document().subject(), *of);
  });
  connect(&window.document(), &Document::annotationsOpened, this, &AnnotationDesk::setBook);
  connect(&window, &MainWindow::subjectRequested, this,
          [this](const QString& wanted) { showSubject(wanted.toStdString()); });
  connectViews();
}

AnnotationDesk::~AnnotationDesk() = default;

void AnnotationDesk::connectViews() {
  TimelineView& timeline = m_window.timeline();
  const auto refuse = [this](const QString& why) { m_window.messages().showInformation(why); };
  const auto ask = [this](const Annotations& next, const QString& what) { change(next, what); };
  connect(&timeline, &TimelineView::annotationsRequested, this, ask);
  connect(&timeline, &TimelineView::labelRefused, this, refuse);
  connect(&timeline, &TimelineView::tierChosen, this, &AnnotationDesk::setActiveTier);
  connect(&timeline, &TimelineView::annotationChosen, this, &AnnotationDesk::select);
  connect(&timeline, &TimelineView::lanesChanged, this, &AnnotationDesk::show);
  connect(m_panel, &AnnotationPanel::changeRequested, this, ask);
  connect(m_panel, &AnnotationPanel::refused, this, refuse);
  connect(m_panel, &AnnotationPanel::tierChosen, this, &AnnotationDesk::setActiveTier);
  connect(m_panel, &AnnotationPanel::annotationChosen, this, &AnnotationDesk::select);
  connect(m_panel, &AnnotationPanel::conflictRequested, this, &AnnotationDesk::setConflict);
  connect(m_panel, &AnnotationPanel::seekRequested, &m_window.ticker(), &FrameTicker::seek);
  connect(m_panel, &AnnotationPanel::subjectRequested, this,
          [this](const QString& subject) { showSubject(subject.toStdString()); });
  connect(m_panel, &AnnotationPanel::visibilityRequested, this, [this](const QString& tier, bool on) {
    widgets::TimelineLanes lanes = m_window.timeline().lanes();
    lanes.set_tier_shown(tier.toStdString(), on);
    m_window.timeline().setLanes(lanes);
  });
  connect(&m_window.panels(), &PanelArea::wantedChanged, this, [this](const QString& id, bool on) {
    if (id != panel_id) return;
    show();
    if (on) m_window.makeRoomForLanes();
  });
  // A take has no live end: at its end the cursor stays.
  connect(&m_window.ticker(), &FrameTicker::playbackChanged, this, [this](const Playback& playback) {
    if (showsTake() && playback.state == Playback::State::Following) m_window.ticker().pause();
  });
}

std::shared_ptr<const MotionLibrary> AnnotationDesk::library() const {
  return m_window.session() ? m_window.session()->material().library : nullptr;
}

void AnnotationDesk::onSessionStarted() {
  const auto of = library();
  if (!of) return;
  m_state.start(*of);
  onOtherBook();
}

void AnnotationDesk::setBook(AnnotationBook book) {
  m_feed->forget();  // pending updates belong to another project
  m_state.set_book(std::move(book), library().get());
  onOtherBook();
}

void AnnotationDesk::onOtherBook() {
  for (const auto& [subject, annotations] : m_state.all())
    if (!subject.empty()) m_feed->put(subject, annotations);
  keep();
  emit subjectChanged();
  tell();
}

void AnnotationDesk::showSubject(const std::string& wanted) {
  if (wanted == subject() && m_window.session()) {
    m_window.panels().want(panel_id, true);
    return;
  }
  if (const auto of = library(); of && !wanted.empty() && of->find_take(wanted) < 0) {
    show();  // the list returns to the shown subject
    return m_window.messages().showError(
        QString("%1: it is not in the library %2. Its annotations are kept with the session: open the "
                "session together with its library (both files at once)")
            .arg(text(wanted), text(of->name())));
  }
  const Status shown = m_stage->show(wanted);
  if (!shown) return m_window.messages().showError(words(shown.error()));
  if (showsTake()) m_window.panels().want(panel_id, true);
  emit subjectChanged();
  tell();
  m_window.makeRoomForLanes();
}

bool AnnotationDesk::edit(const Result<LabelEdit>& edit) {
  if (!edit) {
    m_window.messages().showInformation(words(edit.error()));
    return false;
  }
  if (!m_window.session()) return true;
  if (auto step = m_state.step(subject(), edit->next, edit->what))
    m_window.undoStack().push(new AnnotationCommand(*this, std::move(*step)));
  if (edit->tier) setActiveTier(*edit->tier);
  if (edit->selected) select(*edit->selected);
  return true;
}

void AnnotationDesk::change(Annotations next, const QString& what) {
  edit(LabelEdit{std::move(next), what.toStdString()});
}

/// Where it is saved and exported from.
void AnnotationDesk::keep() {
  m_window.document().put(m_state.changed());
}

bool AnnotationDesk::apply(const AnnotationStep& step, AnnotationState::Direction direction) {
  if (!m_state.apply(step, direction)) return false;
  keep();
  if (!step.subject.empty()) m_feed->put(step.subject, m_state.annotations_of(step.subject));
  tell();
  if (step.subject != subject())
    m_window.messages().showInformation(
        QString("%1 of %2, which is not shown")
            .arg(text(step.what), step.subject.empty() ? "the session" : text(step.subject)));
  return true;
}

EditPlace AnnotationDesk::place() const {
  const Playback& playback = m_window.ticker().playback();
  EditPlace place{activeTier(), selected(), conflict(), range(), fps(), playback.cursor_s};
  if (const auto chosen = playback.range()) place.in_out = {chosen->from_s, chosen->to_s};
  return place;
}

bool AnnotationDesk::isOpen() const {
  const auto& tiers = annotations().tiers();
  return showsTake() || m_window.panels().isWanted(panel_id) ||
         std::any_of(tiers.begin(), tiers.end(),
                     [](const AnnotationTier& tier) { return !tier.annotations.empty(); });
}

void AnnotationDesk::show() {
  const Annotations::Range whole = range();
  TimelineView& timeline = m_window.timeline();
  const bool open = isOpen();
  timeline.showAnnotations(open ? annotations() : Annotations(), {conflict(), whole, fps()});
  timeline.showChosen(open ? activeTier() : 0, selected());
  QStringList takes, absent;
  if (const auto of = library()) {
    for (const LibraryTake& take : of->takes()) takes << text(take.name);
    for (const auto& [take, count] : annotated_elsewhere(m_state.all(), *of)) absent << text(take);
  }
  m_panel->showSubjects(takes, absent, text(subject()));
  std::set<std::string> hidden;
  for (const widgets::TierLane& lane : timeline.lanes().tiers())
    if (!timeline.lanes().is_shown(lane)) hidden.insert(lane.name);
  m_panel->show({annotations(), whole, fps(), activeTier(), selected(), conflict(), hidden});
}

Annotations::Range AnnotationDesk::range() const {
  if (const TakeFrames* take = m_stage->take()) return {0, take->take_frames() / take->fps()};
  const Playback& playback = m_window.ticker().playback();
  return {std::min(0.0, playback.first_s), std::max(playback.last_s, playback.first_s)};
}

double AnnotationDesk::fps() const {
  return m_stage->take() ? m_stage->take()->fps() : 0;
}

void AnnotationDesk::setActiveTier(int tier) {
  if (m_state.choose_tier(tier)) tell();
}

void AnnotationDesk::select(int annotation) {
  if (m_state.select(annotation)) tell();
}

void AnnotationDesk::setConflict(Conflict conflict) {
  m_state.set_conflict(conflict);
  tell();
}

void AnnotationDesk::tell() {
  show();
  emit changed();
}

}  // namespace abrazo::app
