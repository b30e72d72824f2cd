#include "app/workbench/labels/annotation_desk.hpp"

#include <QSplitter>
#include <QUndoCommand>
#include <algorithm>

#include "app/workbench/document/library_feed.hpp"
#include "app/workbench/document/recorded_session.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "app/workbench/shell/subject_stage.hpp"
#include "core/annotation/annotated_library.hpp"
#include "widgets/annotation/annotation_panel.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app {
namespace {

using widgets::AnnotationPanel;
using widgets::TimelineView;

constexpr const char* panel_id = "annotation";

/// Every value of a role or move tier has a key: roles a and b, moves digits.
void give_keys(Annotations& annotations) {
  for (const AnnotationTier& tier : std::vector<AnnotationTier>(annotations.tiers())) {
    auto vocabulary = tier.vocabulary;
    const bool has_keys = std::any_of(vocabulary.begin(), vocabulary.end(),
                                      [](const VocabularyEntry& entry) { return entry.key != 0; });
    if (has_keys || tier.kind == TierKind::Note) continue;
    char digit = '1';
    for (VocabularyEntry& entry : vocabulary) {
      const bool is_role = tier.kind == TierKind::Role && entry.value.size() == 1;
      entry.key = is_role ? entry.value.front() : digit <= '9' ? digit++ : '\0';
    }
    (void)annotations.set_vocabulary(tier.id, std::move(vocabulary));
  }
}

}  // namespace

/// From one whole value to another. Of no use once another session or project is open.
class ChangeAnnotations : public QUndoCommand {
 public:
  ChangeAnnotations(AnnotationDesk& desk, std::string subject, Annotations after, const QString& what)
      : QUndoCommand(what),
        m_desk(desk),
        m_generation(desk.m_generation),
        m_subject(std::move(subject)),
        m_before(desk.annotations_of(m_subject)),
        m_after(std::move(after)) {}

  void redo() override { change(m_after); }
  void undo() override { change(m_before); }

 private:
  void change(const Annotations& annotations) {
    m_desk.m_generation == m_generation ? m_desk.set(m_subject, annotations, text()) : setObsolete(true);
  }

  AnnotationDesk& m_desk;
  int m_generation;
  std::string m_subject;
  Annotations m_before, m_after;
};

AnnotationDesk::AnnotationDesk(MainWindow& window)
    : QObject(&window),
      m_window(window),
      m_panel(new AnnotationPanel),
      m_feed(new LibraryFeed(window.document(), this)),
      m_stage(std::make_unique<SubjectStage>(window)) {
  m_panel->setColours(window.colours());
  window.addPanel(panel_id, "Annotation", m_panel, Qt::RightDockWidgetArea, false);
  connect(&window, &MainWindow::coloursChanged, m_panel, &AnnotationPanel::setColours);
  connect(&window, &MainWindow::sessionStarted, this, &AnnotationDesk::onSessionStarted);
  connect(&window, &MainWindow::sessionEnding, this, [this] {
    m_feed->forget();
    m_stage->forget();
  });
  connect(m_feed, &LibraryFeed::failed, &window.messages(), &widgets::MessageBar::showError);
  connect(&window.document(), &Document::libraryReplaced, this, [this] {
    if (showsTake()) m_stage->renew();
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
    if (on) makeRoom();
  });
  // A take has no live end: at its end the cursor stays.
  connect(&m_window.ticker(), &FrameTicker::playbackChanged, this, [this](const Playback& playback) {
    if (showsTake() && playback.state == Playback::State::Following) m_window.ticker().pause();
  });
}

std::shared_ptr<const MotionLibrary> AnnotationDesk::library() const {
  return m_window.session() ? m_window.session()->material().library : nullptr;
}

const std::string& AnnotationDesk::subject() const {
  return m_window.document().subject();
}

const Annotations& AnnotationDesk::annotations_of(const std::string& subject) const {
  static const Annotations nothing;
  const auto found = m_book.find(subject);
  return found == m_book.end() ? nothing : found->second;
}

/// As the library has it; what is said of a session has the same words.
Annotations AnnotationDesk::begun(const std::string& subject) const {
  const auto of = library();
  Annotations annotations;
  if (!of || of->takes().empty()) return annotations;
  const bool is_take = of->find_take(subject) >= 0;
  annotations = annotations_of_take(*of, is_take ? subject : of->takes().front().name);
  if (!is_take) {
    const auto tiers = annotations.tiers();
    annotations = {};
    for (const AnnotationTier& tier : tiers) {
      auto vocabulary = tier.vocabulary;
      if (tier.kind == TierKind::Role) vocabulary = {{"a", "user leads"}, {"b", "partner leads"}};
      (void)annotations.add_tier(tier.name, tier.kind, std::move(vocabulary));
    }
  }
  (void)annotations.add_tier("note", TierKind::Note, {});
  give_keys(annotations);
  return annotations;
}

void AnnotationDesk::beginIfNew(const std::string& subject) {
  if (!annotations_of(subject).empty()) return;
  m_book[subject] = m_begun[subject] = begun(subject);
}

AnnotationBook AnnotationDesk::book() const {
  AnnotationBook changed;
  for (const auto& [subject, annotations] : m_book) {
    const auto known = m_begun.find(subject);
    if (known == m_begun.end() || known->second != annotations) changed[subject] = annotations;
  }
  return changed;
}

void AnnotationDesk::onSessionStarted() {
  const auto of = library();
  if (!of) return;
  m_book.erase("");
  if (m_library != of->name()) m_book.clear();
  std::erase_if(m_book, [&of](const auto& entry) { return of->find_take(entry.first) < 0; });
  m_library = of->name();
  ++m_generation;
  beginIfNew("");
  for (const auto& [subject, annotations] : m_book)
    if (!subject.empty()) m_feed->put(subject, annotations);
  keep();
  m_activeTier = 0;
  settleChosen();
  show();
  emit subjectChanged();
  emit annotationsChanged();
}

void AnnotationDesk::setBook(AnnotationBook book) {
  m_feed->forget();  // what waits there was said of the takes by another project
  m_book = std::move(book);
  m_begun.clear();
  ++m_generation;
  beginIfNew("");
  beginIfNew(subject());
  for (const auto& [subject, annotations] : m_book)
    if (!subject.empty()) m_feed->put(subject, annotations);
  keep();
  settleChosen();
  show();
  emit subjectChanged();
  emit annotationsChanged();
}

void AnnotationDesk::showSubject(const std::string& wanted) {
  if (wanted == subject() && m_window.session()) {
    m_window.panels().want(panel_id, true);
    return;
  }
  const Status shown = m_stage->show(wanted);
  if (!shown) return m_window.messages().showError(QString::fromStdString(shown.error().text()));
  beginIfNew(wanted);
  if (showsTake()) m_window.panels().want(panel_id, true);
  const AnnotationTier* moves = annotations().first_of(TierKind::Move);
  m_activeTier = moves ? moves->id : 0;
  m_selected = 0;
  settleChosen();
  show();
  makeRoom();
  emit subjectChanged();
  emit annotationsChanged();
}

void AnnotationDesk::change(Annotations next, const QString& what) {
  change(subject(), std::move(next), what);
}

void AnnotationDesk::change(const std::string& subject, Annotations next, const QString& what) {
  if (!m_window.session() || next == annotations_of(subject)) return;
  m_window.undoStack().push(new ChangeAnnotations(*this, subject, std::move(next), what));
}

bool AnnotationDesk::changeOrTell(const Status& done, Annotations next, const QString& what) {
  if (done)
    change(std::move(next), what);
  else
    m_window.messages().showInformation(QString::fromStdString(done.error().text()));
  return done.ok();
}

void AnnotationDesk::suggest(Annotations next) {
  m_book[subject()] = std::move(next);
  keep();
  show();
  emit annotationsChanged();
}

/// Where it is saved and exported from.
void AnnotationDesk::keep() {
  m_window.document().put(book());
}

void AnnotationDesk::set(const std::string& of, const Annotations& annotations, const QString& what) {
  m_book[of] = annotations;
  keep();
  if (!of.empty()) m_feed->put(of, annotations);
  if (of != subject())
    return m_window.messages().showInformation(
        QString("%1 of %2, which is not shown")
            .arg(what, of.empty() ? "the session" : QString::fromStdString(of)));
  settleChosen();
  show();
  emit annotationsChanged();
}

/// What is chosen is there.
void AnnotationDesk::settleChosen() {
  const Annotations& shown = annotations();
  if (!shown.find(m_selected)) m_selected = 0;
  if (shown.tier(m_activeTier)) return;
  const AnnotationTier* moves = shown.first_of(TierKind::Move);
  m_activeTier = moves ? moves->id : shown.empty() ? 0 : shown.tiers().front().id;
}

bool AnnotationDesk::isOpen() const {
  const auto& tiers = annotations().tiers();
  return showsTake() || m_window.panels().isWanted(panel_id) ||
         std::any_of(tiers.begin(), tiers.end(),
                     [](const AnnotationTier& tier) { return !tier.annotations.empty(); });
}

/// For all lanes, as far as half of the window goes.
void AnnotationDesk::makeRoom() {
  QWidget* box = m_window.timeline().parentWidget();
  auto* split = qobject_cast<QSplitter*>(box->parentWidget());
  if (!split || split->count() != 2) return;
  const QList<int> sizes = split->sizes();
  const int whole = sizes[0] + sizes[1], wanted = std::min(box->sizeHint().height(), whole / 2);
  if (sizes[1] < wanted) split->setSizes({whole - wanted, wanted});
}

void AnnotationDesk::show() {
  const Annotations::Range whole = range();
  TimelineView& timeline = m_window.timeline();
  const bool open = isOpen();
  timeline.showAnnotations(open ? annotations() : Annotations(), {m_conflict, whole, fps()});
  timeline.showChosen(open ? m_activeTier : 0, m_selected);
  QStringList takes;
  if (const auto of = library())
    for (const LibraryTake& take : of->takes()) takes << QString::fromStdString(take.name);
  m_panel->showSubjects(takes, QString::fromStdString(subject()));
  std::set<std::string> hidden;
  for (const widgets::TierLane& lane : timeline.lanes().tiers())
    if (!timeline.lanes().is_shown(lane)) hidden.insert(lane.name);
  m_panel->show({annotations(), whole, fps(), m_activeTier, m_selected, m_conflict, hidden});
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
  if (tier == m_activeTier || !annotations().tier(tier)) return;
  m_activeTier = tier;
  if (const AnnotationTier* of = annotations().tier_of(m_selected); of && of->id != tier) m_selected = 0;
  show();
}

void AnnotationDesk::select(int annotation) {
  if (annotation != 0 && !annotations().find(annotation)) return;
  if (annotation == m_selected) return;
  m_selected = annotation;
  if (const AnnotationTier* of = annotations().tier_of(annotation)) m_activeTier = of->id;
  show();
  emit selectionChanged();
}

void AnnotationDesk::setConflict(Conflict conflict) {
  m_conflict = conflict;
  show();
  emit conflictChanged();
}

}  // namespace abrazo::app
