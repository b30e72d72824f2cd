#include "app/workbench/compare/comparison_desk.hpp"

#include <thread>
#include <utility>

#include "app/workbench/compare/comparison_words.hpp"
#include "app/workbench/document/document.hpp"
#include "app/workbench/shell/frame_ticker.hpp"
#include "widgets/compare/figure_rows.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/settings/settings_panel.hpp"

namespace abrazo::app {
namespace {

using widgets::ComparePanel;

constexpr int rest_ms = 60;               // a moving slider or cursor requests nothing yet
constexpr std::uint64_t most_behind = 4;  // frames that a ghost may be older than a live frame

/// The run's pose at a recorded frame, or just before it.
std::optional<PairPose> pose_at(const FrameHistory& run, const FrameSnapshot& recorded) {
  const FrameSnapshotPtr frame = run.at(recorded.time_s);
  if (!frame || frame->index > recorded.index || recorded.index - frame->index > most_behind) return {};
  return frame->result.result;
}

/// The frames of a long comparison take a second to free. One that goes on shares them with its next state.
void free_elsewhere(std::shared_ptr<const Comparison> done) {
  if (done.use_count() != 1) return;
  if (done->a.use_count() != 1 && done->b.use_count() != 1) return;
  std::thread([last = std::move(done)]() mutable { last.reset(); }).detach();
}

}  // namespace

ComparisonDesk::ComparisonDesk(Document& document, FrameTicker& ticker, widgets::SceneView& scene,
                               ComparePanel& panel)
    : QObject(&panel), m_document(document), m_ticker(ticker), m_scene(scene), m_panel(panel) {
  m_still.start();
  connect(&document, &Document::began, this, &ComparisonDesk::startSession);
  connect(&document, &Document::ending, this, &ComparisonDesk::endSession);
  connect(&document, &Document::libraryReplaced, this, &ComparisonDesk::endSession);  // solved anew with it
  connect(&ticker, &FrameTicker::playbackAsked, this, &ComparisonDesk::tryWhereParked);
  connect(&ticker, &FrameTicker::playbackChanged, this, &ComparisonDesk::refresh);
  connect(&ticker, &FrameTicker::frameReady, this, &ComparisonDesk::showGhosts);
  connect(&panel, &ComparePanel::spanRequested, this, [this] {
    m_whatIf.asked.reset();
    m_cancelled.reset();
  });
  connect(&panel, &ComparePanel::cancelRequested, this, &ComparisonDesk::cancel);
  connect(&panel, &ComparePanel::seekRequested, &ticker, &FrameTicker::seek);
}

ComparisonDesk::~ComparisonDesk() = default;

bool ComparisonDesk::Work::isOf(const std::optional<ComparisonTask>& task) const {
  return result && task && result->task == *task;
}

void ComparisonDesk::startSession() {
  ++m_session;
  setFrozen({});  // A was frozen in the session before
}

void ComparisonDesk::endSession() {
  for (auto* each : {&m_whatIf.result, &m_shadow.result, &m_shown, &m_listed})
    free_elsewhere(std::exchange(*each, nullptr));
  m_whatIf = {};
  m_shadow = {};
  m_cancelled.reset();
  m_scene.showComparison({}, {});
}

void ComparisonDesk::freeze() {
  const Settings live = m_document.liveSettings();
  m_document.useTriedSettings();  // they are B now
  setFrozen(live);
}

void ComparisonDesk::setFrozen(const std::optional<Settings>& settings) {
  if (!settings) setAside(false);
  m_frozen = settings;
  tryWhereParked();
  const auto* history = m_ticker.history();
  m_frozenAt_s = history ? history->span().last_s : 0;
  ask(m_shadow, std::nullopt);
  m_whatIf.asked.reset();
  m_cancelled.reset();
  emit frozenChanged(m_frozen.has_value());
}

void ComparisonDesk::setAside(bool on) {
  if (on && !m_frozen) freeze();
  m_isAside = on;
  m_document.setAside(on);
  emit asideChanged(on);
}

void ComparisonDesk::cancel() {
  m_cancelled = m_whatIf.asked;
  if (m_whatIf.runner) m_whatIf.runner->cancel();
  m_panel.showProgress(-1);
}

CompareSituation ComparisonDesk::situation() const {
  return {m_frozen,       m_document.settings(), m_isAside, m_ticker.playback(), m_ticker.shown(),
          m_panel.span(), m_document.triedPin()};
}

void ComparisonDesk::tryWhereParked() {
  if (!m_document.session() || !m_ticker.history() || m_document.session()->looksElsewhere()) return;
  const Playback& playback = m_ticker.playback();
  const bool looks_back = playback.is_live && playback.state != Playback::State::Following;
  // Comparing with a frozen A says by itself which settings the live solver has.
  m_document.setTries(looks_back && !m_frozen);
  if (!looks_back) m_document.tryPin({});
}

void ComparisonDesk::refresh() {
  tryWhereParked();
  if (!m_document.session() || !m_ticker.history() || m_document.session()->looksElsewhere()) return;
  const CompareSituation now = situation();
  const double cursor_s = now.shown ? now.shown->time_s : 0;
  const bool is_moving = now.playback.state != Playback::State::Following && cursor_s != m_cursor_s;
  if (m_tried != now.present || is_moving) m_still.start();
  m_tried = now.present;
  m_cursor_s = cursor_s;
  plan(now);
  poll(m_whatIf);
  poll(m_shadow);
  choose(now);
  if (m_panel.isVisible()) showPanel(now);
}

void ComparisonDesk::plan(const CompareSituation& now) {
  const bool is_at_rest = m_still.elapsed() >= rest_ms;
  const auto shadow = shadow_task(now, m_ticker.history()->span().last_s);
  const bool is_same =
      shadow && m_shadow.asked && shadow->a == m_shadow.asked->a && shadow->b == m_shadow.asked->b;
  const bool differs = now.frozen && now.present != *now.frozen;
  if (!differs && !is_same) ask(m_shadow, std::nullopt);
  if (differs && !is_same && (!now.is_aside || is_at_rest)) ask(m_shadow, shadow);

  if (!m_panel.isVisible() && !m_document.triesOther()) return ask(m_whatIf, std::nullopt);
  const auto what_if = what_if_task(now, m_whatIf.asked ? &*m_whatIf.asked : nullptr);
  const bool is_parked = now.playback.state == Playback::State::Parked;
  if (!what_if && is_parked) return ask(m_whatIf, std::nullopt);
  if (!what_if || what_if == m_cancelled) return;
  const bool is_one_frame = what_if->from_s == what_if->to_s;  // quick enough to follow a drag
  if (is_at_rest || is_one_frame) ask(m_whatIf, what_if);
}

void ComparisonDesk::ask(Work& work, const std::optional<ComparisonTask>& task) {
  if (task == work.asked) return;
  work.asked = task;
  if (!task) {
    if (work.runner) work.runner->cancel();
    free_elsewhere(std::exchange(work.result, nullptr));
    return;
  }
  const Material& material = m_document.session()->material();
  if (!work.runner)
    work.runner = std::make_unique<ComparisonRunner>(material.library, material.excluded_takes,
                                                     m_document.session()->engine().history());
  work.runner->ask(*task);
}

void ComparisonDesk::poll(Work& work) {
  if (!work.runner) return;
  if (auto result = work.runner->take_if_newer(work.seen);
      result && work.asked && result->task == *work.asked)
    free_elsewhere(std::exchange(work.result, std::move(result)));
}

/// The comparison that covers the cursor.
void ComparisonDesk::choose(const CompareSituation& now) {
  const bool is_following = now.playback.state == Playback::State::Following;
  std::shared_ptr<const Comparison> chosen;
  if (!is_following && now.shown && m_whatIf.result && covers(m_whatIf.result->task, now.shown->time_s))
    chosen = m_whatIf.result;
  else if (m_shadow.result && now.shown && now.shown->time_s >= m_shadow.result->task.from_s)
    chosen = m_shadow.result;
  if (chosen == m_shown) return;
  free_elsewhere(std::exchange(m_shown, chosen));
  showGhosts();
}

void ComparisonDesk::showGhosts() {
  const FrameSnapshotPtr& shown = m_ticker.shown();
  std::optional<PairPose> a, b;
  // A take that is looked at has times of its own.
  const bool is_of_session = m_document.session() && !m_document.session()->looksElsewhere();
  if (m_shown && shown && is_of_session) {
    // Recorded bodies are drawn already.
    const ComparisonTask& task = m_shown->task;
    if (task.a && m_shown->a) a = pose_at(*m_shown->a, *shown);
    if (task.b && m_shown->b) b = pose_at(*m_shown->b, *shown);
    if (a && *a == shown->result.result) a.reset();
    if (b && *b == shown->result.result) b.reset();
  }
  m_scene.showComparison(a, b);
}

void ComparisonDesk::showPanel(const CompareSituation& now) {
  m_panel.showSides(sides_of(now, m_frozenAt_s, m_shown.get()));
  if (now.shown) m_panel.showCursor(now.shown->time_s);
  const bool is_working = m_whatIf.asked && m_whatIf.asked != m_cancelled &&
                          !(m_whatIf.isOf(m_whatIf.asked) && m_whatIf.result->done);
  const bool is_parked = now.playback.state != Playback::State::Following;
  m_panel.showProgress(
      is_working && is_parked ? (m_whatIf.isOf(m_whatIf.asked) ? m_whatIf.result->fraction : 0) : -1);
  if (!m_shown || m_shown->steps.empty())
    return free_elsewhere(std::exchange(m_listed, nullptr)), m_panel.showNothing(advice(now, m_shown.get()));
  if (m_shown == m_listed) return;
  free_elsewhere(std::exchange(m_listed, m_shown));
  m_panel.showFigures(m_shown->figures_a, m_shown->figures_b, m_shown->steps, note_of(*m_shown));
}

}  // namespace abrazo::app
