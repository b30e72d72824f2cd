#include "app/workbench/frame_ticker.hpp"

#include <algorithm>
#include <cmath>

namespace abrazo::app {
namespace {

constexpr int display_interval_ms = 16;
constexpr int panel_interval_ms = 80;

}  // namespace

FrameTicker::FrameTicker(QObject* parent) : QObject(parent) {
  m_timer.setTimerType(Qt::PreciseTimer);
  m_timer.setInterval(display_interval_ms);
  connect(&m_timer, &QTimer::timeout, this, &FrameTicker::tick);
}

void FrameTicker::setSources(const FrameHistory* history, const LatestSlot<FrameSnapshot>* latest) {
  m_history = history;
  m_latest = latest;
  m_playback = {};
  m_shown = nullptr;
  m_panelsNow = true;
  if (!history) return m_timer.stop();
  m_clock.start();
  m_panels.start();
  m_timer.start();
}

void FrameTicker::tick() {
  if (!m_history) return;
  const auto span = m_history->span();
  const double elapsed_s = static_cast<double>(m_clock.restart()) / 1000;
  if (span.frames == 0) return;
  m_playback.extend(span.first_s, span.last_s);
  m_playback.advance(elapsed_s);
  const bool following = m_playback.state == Playback::State::Following;
  FrameSnapshotPtr frame = following ? m_latest->newest() : m_history->at(m_playback.cursor_s);
  const bool is_new = frame && frame != m_shown;
  if (is_new) {
    m_shown = frame;
    emit frameReady(frame);
  }
  emit playbackChanged(m_playback);
  if (m_panelsNow || m_panels.elapsed() >= panel_interval_ms) {
    m_panelsNow = false;
    m_panels.restart();
    emit panelsDue();
  }
}

void FrameTicker::changed() {
  m_panelsNow = true;
}

void FrameTicker::toggle() {
  m_playback.toggle();
  changed();
}

void FrameTicker::pause() {
  m_playback.pause();
  changed();
}

void FrameTicker::seek(double time_s) {
  m_playback.seek(time_s);
  changed();
}

void FrameTicker::step(int frames) {
  if (!m_history) return;
  if (const auto frame = m_history->stepped(m_playback.cursor_s, frames)) m_playback.seek(frame->time_s);
  changed();
}

void FrameTicker::goToStart() {
  m_playback.seek(m_playback.first_s);
  changed();
}

void FrameTicker::follow() {
  m_playback.follow();
  changed();
}

void FrameTicker::setSpeed(double factor) {
  m_playback.speed = std::clamp(factor, -8.0, 8.0);
  changed();
}

void FrameTicker::setLoop(bool on) {
  m_playback.loop = on;
  changed();
}

void FrameTicker::setIn() {
  m_playback.in_s = m_playback.cursor_s;
  if (m_playback.out_s <= m_playback.in_s) m_playback.out_s = m_playback.last_s;
  changed();
}

void FrameTicker::setOut() {
  m_playback.out_s = m_playback.cursor_s;
  if (m_playback.in_s >= m_playback.out_s) m_playback.in_s = m_playback.first_s;
  changed();
}

void FrameTicker::clearRange() {
  m_playback.in_s = m_playback.out_s = 0;
  changed();
}

void FrameTicker::shuttle(int direction) {
  if (direction == 0) return pause();
  const bool same = m_playback.state == Playback::State::Playing && m_playback.speed * direction > 0;
  m_playback.speed = same ? std::clamp(2 * m_playback.speed, -8.0, 8.0) : direction;
  if (direction < 0 || m_playback.state == Playback::State::Parked) m_playback.play();
  changed();
}

}  // namespace abrazo::app
