#include "app/workbench/labels/annotation_desk.hpp"

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

AnnotationDesk::AnnotationDesk(MainWindow& window)
    : QObject(&window),
      m_window(window),
      m_panel(new AnnotationPanel),
      m_feed(new LibraryFeed(window.document(), this)),
      m_stage(std::make_unique<SubjectStage>(window)) {
  window.colour(m_panel);
  window.addPanel(panel_id, "Annotation", m_panel, Qt::RightDockWidgetArea, false);
  const Document& document = window.document();
  connect(&document, &Document::began, this, &AnnotationDesk::show);
  connect(&document, &Document::changed, this, [this](ProjectPart part) {
    if (part == ProjectPart::Annotations) show();
  });
  connect(&document, &Document::labelChosen, this, &AnnotationDesk::show);
  connect(&document, &Document::ending, this, [this] { m_stage->forget(); });
  connect(&document, &Document::libraryReplaced, this, [this] {
    if (showsTake()) m_stage->renew();
  });
  connect(&document, &Document::annotated, this, [this](const std::string& subject, const QString& what) {
    if (subject != m_window.document().subject())
      m_window.messages().showInformation(
          QString("%1 of %2, which is not shown").arg(what, subject.empty() ? "the session" : text(subject)));
  });
  const auto refuse = [this](const QString& why) { m_window.messages().showInformation(why); };
  connect(&document, &Document::labelRefused, this, refuse);
  connect(&window.timeline(), &TimelineView::labelRefused, this, refuse);
  connect(m_panel, &AnnotationPanel::refused, this, refuse);
  connect(m_feed, &LibraryFeed::failed, &window.messages(), &widgets::MessageBar::showError);
  connect(&window, &MainWindow::subjectRequested, this,
          [this](const QString& wanted) { showSubject(wanted.toStdString()); });
  connectRequests();
}

AnnotationDesk::~AnnotationDesk() = default;

void AnnotationDesk::connectRequests() {
  const TimelineView& timeline = m_window.timeline();
  Document& document = m_window.document();
  connect(&timeline, &TimelineView::annotationsRequested, &document, &Document::changeAnnotations);
  connect(&timeline, &TimelineView::tierChosen, &document, &Document::chooseTier);
  connect(&timeline, &TimelineView::annotationChosen, &document, &Document::selectLabel);
  connect(m_panel, &AnnotationPanel::changeRequested, &document, &Document::changeAnnotations);
  connect(m_panel, &AnnotationPanel::tierChosen, &document, &Document::chooseTier);
  connect(m_panel, &AnnotationPanel::annotationChosen, &document, &Document::selectLabel);
  connect(m_panel, &AnnotationPanel::conflictRequested, &document, &Document::setConflict);
  connect(&timeline, &TimelineView::lanesChanged, this, &AnnotationDesk::show);
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
  connect(&document, &Document::subjectChanged, this,
          [this] { m_window.panels().favour(showsTake() ? panel_id : QString()); });
  // A take has no live end: at its end the cursor stays.
  connect(&m_window.ticker(), &FrameTicker::playbackChanged, this, [this](const Playback& playback) {
    if (showsTake() && playback.state == Playback::State::Following) m_window.ticker().pause();
  });
}

bool AnnotationDesk::showsTake() const {
  return !m_window.document().subject().empty();
}

std::shared_ptr<const MotionLibrary> AnnotationDesk::library() const {
  return m_window.session() ? m_window.session()->material().library : nullptr;
}

void AnnotationDesk::showSubject(const std::string& wanted) {
  if (wanted == m_window.document().subject() && m_window.session()) {
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
  show();
  m_window.makeRoomForLanes();
}

EditPlace AnnotationDesk::place() const {
  const Playback& playback = m_window.ticker().playback();
  const LabelSelection& labels = m_window.document().labels();
  EditPlace place{labels.tier(), labels.selected(), labels.conflict(), range(), fps(), playback.cursor_s};
  if (const auto chosen = playback.range()) place.in_out = {chosen->from_s, chosen->to_s};
  return place;
}

bool AnnotationDesk::isOpen() const {
  const auto& tiers = m_window.document().annotations().tiers();
  return showsTake() || m_window.panels().isWanted(panel_id) ||
         std::any_of(tiers.begin(), tiers.end(),
                     [](const AnnotationTier& tier) { return !tier.annotations.empty(); });
}

void AnnotationDesk::show() {
  const Annotations::Range whole = range();
  TimelineView& timeline = m_window.timeline();
  const Document& document = m_window.document();
  const LabelSelection& labels = document.labels();
  const bool open = isOpen();
  timeline.showAnnotations(open ? document.annotations() : Annotations(), {labels.conflict(), whole, fps()});
  timeline.showChosen(open ? labels.tier() : 0, labels.selected());
  QStringList takes, absent;
  if (const auto of = library()) {
    for (const LibraryTake& take : of->takes()) takes << text(take.name);
    for (const auto& [take, count] : annotated_elsewhere(document.live().annotations().all(), *of))
      absent << text(take);
  }
  m_panel->showSubjects(takes, absent, text(document.subject()));
  std::set<std::string> hidden;
  for (const widgets::TierLane& lane : timeline.lanes().tiers())
    if (!timeline.lanes().is_shown(lane)) hidden.insert(lane.name);
  m_panel->show(
      {document.annotations(), whole, fps(), labels.tier(), labels.selected(), labels.conflict(), hidden});
}

Annotations::Range AnnotationDesk::range() const {
  if (const TakeFrames* take = m_stage->take()) return {0, take->take_frames() / take->fps()};
  const Playback& playback = m_window.ticker().playback();
  return {std::min(0.0, playback.first_s), std::max(playback.last_s, playback.first_s)};
}

double AnnotationDesk::fps() const {
  return m_stage->take() ? m_stage->take()->fps() : 0;
}

}  // namespace abrazo::app
