#include "app/workbench/labels/label_key_filter.hpp"

#include <QAbstractItemView>
#include <QApplication>
#include <QKeyEvent>
#include <utility>

#include "app/workbench/document/document.hpp"
#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/shell/frame_ticker.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app {
namespace {

/// Release and press of a repeated key have the same time, but may come in different turns of the window.
/// Nobody releases and presses a key again within this time.
constexpr int repetition_ms = 30;

char key_of(const QKeyEvent& event) {
  const int key = event.key();
  if (event.modifiers() & ~Qt::KeypadModifier) return 0;
  if (key >= Qt::Key_1 && key <= Qt::Key_9) return static_cast<char>('1' + key - Qt::Key_1);
  if (key >= Qt::Key_A && key <= Qt::Key_Z) return static_cast<char>('a' + key - Qt::Key_A);
  return 0;
}

/// A table whose cells are edited by typing. Fields keep their keys themselves.
bool is_typed_into(const QWidget* focused) {
  const auto* table = qobject_cast<const QAbstractItemView*>(focused);
  return table && (table->editTriggers() & QAbstractItemView::AnyKeyPressed) &&
         (table->currentIndex().flags() & Qt::ItemIsEditable);
}

}  // namespace

LabelKeyFilter::LabelKeyFilter(Document& document, widgets::TimelineView& timeline, const FrameTicker& ticker,
                               AnnotationDesk& desk)
    : QObject(&desk), m_document(document), m_timeline(timeline), m_ticker(ticker), m_desk(desk) {
  timeline.installEventFilter(this);
  timeline.window()->installEventFilter(this);
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* focused) {
    if (focused) focused->installEventFilter(this);
  });
  m_settle.setSingleShot(true);
  m_settle.setInterval(repetition_ms);
  // One turn later: after a long one the press may have come and not been handled yet.
  connect(&m_settle, &QTimer::timeout, this,
          [this] { QTimer::singleShot(0, this, [this] { draw(m_keys.settle()); }); });
  connect(&ticker, &FrameTicker::playbackChanged, this, [this] {
    const bool said_something = !m_keys.running().empty();
    const auto said = m_keys.follow(now());
    if (said_something) draw(said);
  });
  connect(&document, &Document::annotationsReplaced, this, [this] {
    m_keys.forget();
    show();
  });
}

void LabelKeyFilter::setTaps(bool on) {
  draw(m_keys.set_taps(on, now()));
}

LabelKeys::Moment LabelKeyFilter::now() const {
  const Playback& playback = m_ticker.playback();
  const auto range = playback.range();
  return {playback.cursor_s, m_desk.fps(), playback.state == Playback::State::Parked, playback.speed,
          range ? std::optional(range->to_s) : std::nullopt};
}

const AnnotationTier* LabelKeyFilter::tierOf(char key) const {
  return m_desk.isOpen() ? tier_of_key(m_document.annotations(), m_document.labels().tier(), key) : nullptr;
}

bool LabelKeyFilter::works() const {
  const QWidget* focused = QApplication::focusWidget();
  const bool is_there = focused == &m_timeline || (!m_document.subject().empty() && !is_typed_into(focused));
  return is_there && m_desk.isOpen();
}

bool LabelKeyFilter::claims(const QKeyEvent& event) {
  const char key = key_of(event);
  const bool ours = key != 0 && works() && (tierOf(key) || m_keys.is_held(key));
  m_claimed = ours ? key : '\0';
  return ours;
}

bool LabelKeyFilter::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::FocusOut:
      draw(m_keys.let_all_go(now()));
      break;
    case QEvent::ShortcutOverride:
      m_claimed = 0;
      break;
    case QEvent::KeyPress:
      if (isPressed(*static_cast<QKeyEvent*>(event))) return true;
      break;
    case QEvent::KeyRelease:
      if (isReleased(*static_cast<QKeyEvent*>(event))) return true;
      break;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

/// @return whether it was claimed
bool LabelKeyFilter::isPressed(const QKeyEvent& event) {
  const char key = key_of(event);
  if (key == 0 || std::exchange(m_claimed, '\0') != key) return false;
  const bool began_elsewhere = event.isAutoRepeat() && !m_keys.is_held(key);
  if (began_elsewhere) return true;
  if (m_keys.hold(key) && !event.isAutoRepeat()) press(key);
  return true;
}

/// @return whether it is of a key that is held here
bool LabelKeyFilter::isReleased(const QKeyEvent& event) {
  const char key = key_of(event);
  if (!m_keys.is_held(key)) return false;
  if (event.isAutoRepeat()) return true;
  m_keys.let_go(key, now());
  m_settle.start();
  return true;
}

void LabelKeyFilter::press(char key) {
  const AnnotationTier* tier = tierOf(key);
  if (!tier) return;
  const LabelKeys::Moment moment = now();
  if (!moment.is_parked) return draw(m_keys.press(key, *tier, moment));
  m_document.edit(
      say_at_cursor(m_document.annotations(), m_desk.place(), tier->id, tier->entry_of_key(key)->value));
}

void LabelKeyFilter::draw(const std::vector<LabelKeys::Said>& said) {
  for (const LabelKeys::Said& each : said)
    m_document.edit(label_span(m_document.annotations(), m_desk.place(), each.tier, each.span, each.value));
  show();
}

void LabelKeyFilter::show() {
  std::vector<widgets::RunningLabel> labels;
  for (const auto& [key, running] : m_keys.running())
    labels.push_back({running.tier, running.from_s, running.value});
  m_timeline.showRunning(std::move(labels));
}

}  // namespace abrazo::app
