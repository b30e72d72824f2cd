#include "app/workbench/labels/label_keys.hpp"

#include <QApplication>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>

#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app {
namespace {

constexpr double jump_s = 0.05;  // backwards by more is no tick but a loop that starts over

char key_of(const QKeyEvent& event) {
  const int key = event.key();
  if (event.modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) return 0;
  if (event.modifiers() & Qt::ShiftModifier) return 0;
  if (key >= Qt::Key_1 && key <= Qt::Key_9) return static_cast<char>('1' + key - Qt::Key_1);
  if (key >= Qt::Key_A && key <= Qt::Key_Z) return static_cast<char>('a' + key - Qt::Key_A);
  return 0;
}

double at_frame(double time_s, double fps) {
  return fps > 0 ? std::round(time_s * fps) / fps : time_s;
}

QString words(const std::string& value) {
  return QString::fromStdString(value).replace('_', ' ');
}

}  // namespace

LabelKeys::LabelKeys(MainWindow& window, AnnotationDesk& desk)
    : QObject(&desk), m_window(window), m_desk(desk) {
  window.timeline().installEventFilter(this);
  connect(&window.ticker(), &FrameTicker::playbackChanged, this, &LabelKeys::follow);
  connect(&desk, &AnnotationDesk::subjectChanged, this, [this] {
    m_running.clear();
    show();
  });
}

void LabelKeys::setTaps(bool on) {
  finish();
  m_taps = on;
}

const AnnotationTier* LabelKeys::tierOf(char key) const {
  if (!m_desk.isOpen()) return nullptr;
  const Annotations& annotations = m_desk.annotations();
  const AnnotationTier* active = annotations.tier(m_desk.activeTier());
  if (active && active->entry_of_key(key)) return active;
  if (key < '1' || key > '9') return nullptr;  // letters of other tiers stay what they are in the window
  const AnnotationTier* only = nullptr;
  for (const AnnotationTier& tier : annotations.tiers()) {
    if (!tier.entry_of_key(key)) continue;
    if (only) return nullptr;
    only = &tier;
  }
  return only;
}

bool LabelKeys::means(const QKeyEvent& event) const {
  const char key = key_of(event);
  return key != 0 && tierOf(key) != nullptr;
}

bool LabelKeys::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusOut && !m_taps) finish();
  const bool pressed = event->type() == QEvent::KeyPress;
  if (!pressed && event->type() != QEvent::KeyRelease) return QObject::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  const bool ours = means(*key) || m_running.contains(key_of(*key));
  if (!ours) return QObject::eventFilter(watched, event);
  if (key->isAutoRepeat()) return true;
  pressed ? press(key_of(*key)) : release(key_of(*key));
  return true;
}

void LabelKeys::press(char key) {
  const AnnotationTier* tier = tierOf(key);
  if (!tier) return;
  const std::string value = tier->entry_of_key(key)->value;
  if (m_window.ticker().playback().state == Playback::State::Parked) return sayParked(*tier, value);
  begin(key, *tier, value);
}

void LabelKeys::release(char key) {
  if (!m_taps) end(key, m_window.ticker().playback().cursor_s);
}

/// One value of a tier at a time: what it said so far ends here.
void LabelKeys::begin(char key, const AnnotationTier& tier, const std::string& value) {
  const double here = m_window.ticker().playback().cursor_s;
  const int id = tier.id;
  char before = 0;
  for (const auto& [other, running] : m_running)
    if (running.tier == id) before = other;
  const bool stops = m_taps && before == key;
  if (before != 0) end(before, here);
  if (!stops) m_running[key] = {id, value, here};  // the same key again: nothing is said from here
  m_last = here;
  show();
}

void LabelKeys::end(char key, double at_s) {
  const auto found = m_running.find(key);
  if (found == m_running.end()) return;
  const Running said = found->second;
  m_running.erase(found);
  show();
  const double fps = m_desk.fps();
  const double from = at_frame(std::min(said.from_s, at_s), fps);
  const double to = at_frame(std::max(said.from_s, at_s), fps);
  if (to <= from) return;
  Annotations next = m_desk.annotations();
  const auto drawn = next.draw(said.tier, from, to, said.value, m_desk.conflict(), m_desk.range());
  m_desk.changeOrTell(drawn ? Status(Done{}) : Status(drawn.error()), std::move(next),
                      "label " + words(said.value));
}

void LabelKeys::finish() {
  while (!m_running.empty()) end(m_running.begin()->first, m_window.ticker().playback().cursor_s);
}

void LabelKeys::sayParked(const AnnotationTier& tier, const std::string& value) {
  Annotations next = m_desk.annotations();
  const Annotation* selected = next.find(m_desk.selected());
  const AnnotationTier* of = selected ? next.tier_of(selected->id) : nullptr;
  if (of && of->id == tier.id) {
    const Status done = next.say(selected->id, value, selected->detail, selected->confidence);
    m_desk.changeOrTell(done, std::move(next), "label " + words(value));
    return;
  }
  const Playback& playback = m_window.ticker().playback();
  const auto range = playback.range();
  double from = range ? range->from_s : at_frame(playback.cursor_s, m_desk.fps());
  double to = range ? range->to_s : m_desk.range().last_s;
  Conflict conflict = m_desk.conflict();
  if (!range) {
    for (const Annotation& each : tier.annotations)
      if (each.start_s > from + 1e-6) to = std::min(to, each.start_s);
    conflict = Conflict::Replace;  // it begins here, whatever is said here now
  }
  const auto drawn = next.draw(tier.id, from, to, value, conflict, m_desk.range());
  m_desk.changeOrTell(drawn ? Status(Done{}) : Status(drawn.error()), std::move(next),
                      "label " + words(value));
}

/// A loop that starts over ends what is said at its end; when tapping, it goes on at its beginning.
void LabelKeys::follow(const Playback& playback) {
  const double here = playback.cursor_s;
  const bool stands = playback.state == Playback::State::Parked;
  if (!m_running.empty() && (stands || (playback.speed > 0 && here < m_last - jump_s))) {
    const auto said = m_running;
    const double until = stands ? here : std::max(m_last, playback.range() ? playback.range()->to_s : m_last);
    for (const auto& [key, running] : said) end(key, until);
    if (m_taps && !stands)
      for (const auto& [key, running] : said) m_running[key] = {running.tier, running.value, here};
    show();
  }
  m_last = here;
}

void LabelKeys::show() {
  std::vector<widgets::RunningLabel> labels;
  for (const auto& [key, running] : m_running)
    labels.push_back({running.tier, running.from_s, running.value});
  m_window.timeline().showRunning(std::move(labels));
}

}  // namespace abrazo::app
