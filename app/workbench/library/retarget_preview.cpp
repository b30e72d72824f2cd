#include "app/workbench/library/retarget_preview.hpp"

#include <QAction>
#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "widgets/scene/view/scene_view.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app {
namespace {

using widgets::ScenePart;

constexpr double near_room = 0.9;     // whoever came nearer wants to be there
constexpr double enough_room = 0.98;  // less, and a head is behind the buttons

/// A take has no user and no source that continues; the recording is drawn as another run.
widgets::PartVisibility shown_parts() {
  widgets::PartVisibility parts = widgets::default_visibility;
  for (const ScenePart absent :
       {ScenePart::User, ScenePart::SelectedPair, ScenePart::MeshWithin, ScenePart::LookAhead})
    parts[static_cast<std::size_t>(absent)] = false;
  return parts;
}

}  // namespace

RetargetPreview::RetargetPreview(QWidget* parent)
    : QWidget(parent),
      m_scene(new widgets::SceneView(this)),
      m_transport(new widgets::TransportBar(this)),
      m_ruler(new widgets::TimelineView(this)),
      m_state(new QLabel(this)),
      m_sides(new QButtonGroup(this)) {
  setAccessibleName("Preview");
  m_transport->showOfTake(true);
  widgets::TimelineLanes none;
  none.set_text("");
  m_ruler->setLanes(none);
  m_ruler->showOfTake(true);
  m_ruler->setFixedHeight(static_cast<int>(m_ruler->lanes().whole_px()));
  m_state->setObjectName("previewState");
  m_state->setWordWrap(true);
  m_state->setMinimumHeight(2 * m_state->fontMetrics().lineSpacing());
  m_state->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(makeSides());
  column->addWidget(m_scene, 1);
  column->addWidget(m_transport);
  column->addWidget(m_ruler);
  column->addWidget(m_state);
  m_scene->setVisibility(shown_parts());
  wire();
  addKeys();
  setSide(Side::Both);
}

RetargetPreview::~RetargetPreview() {
  m_ticker.setSources(nullptr, nullptr);
}

QWidget* RetargetPreview::makeSides() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  const std::pair<const char*, const char*> sides[] = {
      {"A: recording", "The pair as recorded"},
      {"Both", "The other bodies, and the recording as dashed lines"},
      {"B: other bodies", "The pair on the chosen bodies"}};
  int id = 0;
  for (const auto& [name, tip] : sides) {
    auto* button = new QToolButton(box);
    button->setObjectName("chip");
    button->setText(name);
    button->setToolTip(QString(tip) + " (A and B exchange them)");
    button->setCheckable(true);
    m_sides->addButton(button, id++);
    row->addWidget(button);
  }
  row->addStretch(1);
  connect(m_sides, &QButtonGroup::idClicked, this, [this](int side) { setSide(static_cast<Side>(side)); });
  return box;
}

void RetargetPreview::wire() {
  using widgets::TimelineView;
  using widgets::TransportBar;
  connect(&m_ticker, &FrameTicker::frameReady, this, &RetargetPreview::showFrame);
  connect(m_transport, &TransportBar::toggleRequested, &m_ticker, &FrameTicker::toggle);
  connect(m_transport, &TransportBar::stepRequested, &m_ticker, &FrameTicker::step);
  connect(m_transport, &TransportBar::startRequested, &m_ticker, &FrameTicker::goToStart);
  connect(m_transport, &TransportBar::followRequested, &m_ticker, &FrameTicker::follow);
  connect(m_transport, &TransportBar::speedRequested, &m_ticker, &FrameTicker::setSpeed);
  connect(m_transport, &TransportBar::everyFrameRequested, &m_ticker, &FrameTicker::setEveryFrame);
  connect(m_transport, &TransportBar::loopRequested, &m_ticker, &FrameTicker::setLoop);
  connect(m_transport, &TransportBar::repeatRequested, &m_ticker, &FrameTicker::setRepeat);
  connect(m_transport, &TransportBar::formatRequested, m_transport, &TransportBar::setFormat);
  connect(m_ruler, &TimelineView::seekRequested, &m_ticker, &FrameTicker::seek);
  connect(m_ruler, &TimelineView::rangeRequested, &m_ticker, &FrameTicker::setRange);
  connect(m_ruler, &TimelineView::scrubbing, &m_ticker, &FrameTicker::setScrubbing);
  connect(&m_ticker, &FrameTicker::playbackChanged, this, [this](const Playback& playback) {
    const auto& shown = m_ticker.shown();
    m_transport->showPlayback(playback, shown ? static_cast<long long>(shown->input_frame) : -1);
    m_transport->showAchieved(m_ticker.achievedSpeed());
    m_ruler->showPlayback(playback);
  });
  m_ticker.setPictures([this] { return m_scene->renderedFrames(); });
}

/// The keys of the window's transport, where the focus is in the preview.
void RetargetPreview::addKeys() {
  const auto add = [this](const char* key, auto act) {
    auto* action = new QAction(this);
    action->setShortcut(QKeySequence(key));
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    addAction(action);
    connect(action, &QAction::triggered, this, act);
  };
  add("Space", [this] { m_ticker.toggle(); });
  add("Left", [this] { m_ticker.step(-1); });
  add("Right", [this] { m_ticker.step(1); });
  add("Home", [this] { m_ticker.goToStart(); });
  add("End", [this] { m_ticker.follow(); });
  add("A", [this] { setSide(Side::Recording); });
  add("B", [this] { setSide(m_side == Side::Retargeted ? Side::Both : Side::Retargeted); });
}

void RetargetPreview::setColours(const widgets::Palette& palette) {
  m_scene->setColours(palette);
  m_transport->setColours(palette);
  m_ruler->setColours(palette);
}

void RetargetPreview::showRecording(const PreviewedPair& pair, std::shared_ptr<const MotionLibrary> library) {
  m_ticker.setSources(nullptr, nullptr);
  m_pair = pair;
  m_inScene = nullptr;
  m_scene->setLibrary(std::move(library));
  m_transport->setRate(pair.fps());
  m_ruler->showOtherFrames();
  lookAt();
  m_ticker.setSources(&m_history, &m_latest);
  m_ticker.setEnd(m_history.span().last_s);
  Playback from_the_beginning;
  from_the_beginning.state = Playback::State::Playing;
  from_the_beginning.loop = true;
  m_ticker.resume(from_the_beginning);
  m_ruler->refresh(FrameHistory(), m_ticker.playback());  // its lanes are empty, its axis is the take's
  m_ruler->showAll();
  setEnabled(true);
}

void RetargetPreview::showPieces(const PreviewedPair& pair) {
  m_pair = pair;
  lookAt();
}

void RetargetPreview::showNothing() {
  m_ticker.setSources(nullptr, nullptr);
  m_history.set_store(nullptr);
  m_pair = {};
  setEnabled(false);
}

void RetargetPreview::showFrame(const FrameSnapshotPtr& frame) {
  // While it plays the camera follows. A view that a person brought nearer stays.
  const bool is_parked = m_ticker.playback().state == Playback::State::Parked;
  const bool was_in_view = m_inScene && m_scene->roomFor(m_inScene->result.result) >= near_room;
  m_inScene = frame;
  m_scene->showFrame(frame);
  if (is_parked && was_in_view && m_scene->roomFor(frame->result.result) < enough_room) m_scene->frameAll();
  std::optional<PairPose> recording;
  if (m_side == Side::Both) recording = frame->result.selected_pair;
  m_scene->showComparison(recording, {});
}

/// The next tick shows the frame anew: it is another object.
void RetargetPreview::lookAt() {
  using Shows = RetargetedFrames::Shows;
  if (!m_pair.recorded) return;
  m_history.set_store(std::make_shared<RetargetedFrames>(
      m_pair, m_side == Side::Recording ? Shows::Recording : Shows::Retargeted));
}

void RetargetPreview::showState(const QString& text) {
  m_state->setText(text);
}

void RetargetPreview::setSide(Side side) {
  m_side = side;
  m_sides->button(static_cast<int>(side))->setChecked(true);
  lookAt();
}

}  // namespace abrazo::app
