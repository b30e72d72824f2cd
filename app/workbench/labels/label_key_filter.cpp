#include "app/workbench/labels/label_key_filter.hpp"

#include <QKeyEvent>

#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/shell/frame_ticker.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app {
namespace {

char key_of(const QKeyEvent& event) {
  const int key = event.key();
  if (event.modifiers() & ~Qt::KeypadModifier) return 0;
  if (key >= Qt::Key_1 && key <= Qt::Key_9) return static_cast<char>('1' + key - Qt::Key_1);
  if (key >= Qt::Key_A && key <= Qt::Key_Z) return static_cast<char>('a' + key - Qt::Key_A);
  return 0;
}

}  // namespace

LabelKeyFilter::LabelKeyFilter(Document& document, widgets::TimelineView& timeline, const FrameTicker& ticker,
                               AnnotationDesk& desk)
    : QObject(&desk), m_document(document), m_timeline(timeline), m_ticker(ticker), m_desk(desk) {
  timeline.installEventFilter(this);
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

bool LabelKeyFilter::means(const QKeyEvent& event) const {
  const char key = key_of(event);
  return key != 0 && tierOf(key) != nullptr;
}

bool LabelKeyFilter::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusOut && !m_keys.taps()) draw(m_keys.finish(now()));
  const bool pressed = event->type() == QEvent::KeyPress;
  if (!pressed && event->type() != QEvent::KeyRelease) return QObject::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  const bool ours = means(*key) || m_keys.is_running(key_of(*key));
  if (!ours) return QObject::eventFilter(watched, event);
  if (key->isAutoRepeat()) return true;
  pressed ? press(key_of(*key)) : draw(m_keys.release(key_of(*key), now()));
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
