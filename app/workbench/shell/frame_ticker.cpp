#include "app/workbench/shell/frame_ticker.hpp"

#include <algorithm>
#include <cmath>

#include "app/workbench/base/error_words.hpp"
#include "core/session/frames/frame_in_library.hpp"

namespace abrazo::app {
namespace {

constexpr int display_interval_ms = 16;
constexpr int panel_interval_ms = 100;
constexpr int parked_panel_interval_ms = 500;  // only the lanes and curves of the running session are new
constexpr int longest_wait_ms = 400;           // for a picture that may never come: the scene may be hidden
constexpr double measured_over_s = 0.7;

}  // namespace

FrameTicker::FrameTicker(QObject* parent) : QObject(parent) {
  m_timer.setTimerType(Qt::PreciseTimer);
  m_timer.setInterval(display_interval_ms);
  m_timer.setSingleShot(true);
  m_soon.setSingleShot(true);
  m_soon.setInterval(0);
  m_panelsTurn.setSingleShot(true);
  m_panelsTurn.setInterval(0);
  connect(&m_panelsTurn, &QTimer::timeout, this, &FrameTicker::panelsDue);
  // A timer that repeats by itself keeps to its grid: a picture of 20 ms would come every 32 ms.
  connect(&m_timer, &QTimer::timeout, this, [this] {
    m_timer.start();
    tick();
  });
  connect(&m_soon, &QTimer::timeout, this, &FrameTicker::tick);
}

void FrameTicker::setSources(const FrameHistory* history, const LatestSlot<FrameSnapshot>* latest) {
  m_history = history;
  m_latest = latest;
  m_playback = {};
  m_end_s.reset();
  m_shown = m_kept = nullptr;
  m_panelsNow = true;
  m_panelsSoon = m_scrubbing = false;
  m_soon.stop();
  m_panelsTurn.stop();
  if (!history) return m_timer.stop();
  m_clock.start();
  m_panels.start();
  m_sinceShown.start();
  m_timer.start();
}

void FrameTicker::setEnd(double end_s) {
  m_end_s = end_s;
  m_playback.is_live = false;
  m_playback.state = Playback::State::Playing;
}

void FrameTicker::setLibrary(std::shared_ptr<const MotionLibrary> library) {
  m_library = std::move(library);
  m_shown = in_library(m_shown, m_library);
  m_kept = nullptr;  // shown again
  changed();
}

void FrameTicker::resume(const Playback& playback) {
  m_playback = playback;
  m_playback.is_live = !m_end_s;
  if (m_history) {
    const auto span = m_history->span();
    m_playback.extend(span.first_s, m_end_s.value_or(span.last_s));
  }
  changed();
}

void FrameTicker::tick() {
  if (!m_history) return;
  const auto span = m_history->span();
  const double elapsed_s = static_cast<double>(m_clock.nsecsElapsed()) * 1e-9;
  m_clock.restart();
  if (span.frames + span.stored == 0) return;
  m_playback.extend(span.first_s, m_end_s.value_or(span.last_s));
  const double before_s = m_playback.cursor_s;
  advance(elapsed_s);
  // Playing waits for frames that are not solved yet.
  if (m_end_s && m_playback.state == Playback::State::Playing && span.last_s < *m_end_s)
    m_playback.cursor_s = std::min(m_playback.cursor_s, std::max(before_s, span.last_s));
  const bool following = m_playback.state == Playback::State::Following;
  FrameSnapshotPtr frame = following ? m_latest->newest() : nullptr;
  if (!frame) frame = m_history->at(m_playback.cursor_s);
  const bool is_new = frame && frame != m_kept;
  if (is_new) {
    m_kept = frame;
    m_shown = frame = in_library(frame, m_library);
    m_picturesWhenShown = m_pictures ? m_pictures() : 0;
    m_sinceShown.restart();
    emit frameReady(frame);
  }
  emit playbackChanged(m_playback);
  const bool still = m_playback.state == Playback::State::Parked && !m_scrubbing && !m_panelsSoon;
  if (m_panelsNow || m_panels.elapsed() >= (still ? parked_panel_interval_ms : panel_interval_ms)) {
    m_panelsNow = m_panelsSoon = false;
    // The scene is drawn first, in a turn of its own: together they would hold up whoever clicks.
    is_new ? m_panelsTurn.start() : emit panelsDue();
    m_panels.restart();
  }
}

void FrameTicker::advance(double elapsed_s) {
  if (m_playback.state != Playback::State::Playing) return;
  const double speed = std::abs(m_playback.speed);
  if (!m_playback.every_frame) {
    m_playback.advance(elapsed_s);
    passOverGap();
    return measure(elapsed_s * speed, elapsed_s);
  }
  if (waitsForPicture()) return measure(0, elapsed_s);
  const auto next = m_history->stepped(m_playback.cursor_s, m_playback.speed > 0 ? 1 : -1);
  measure(m_playback.advance_to_next(elapsed_s, next->time_s) * speed, elapsed_s);
  passOverGap();
}

void FrameTicker::passOverGap() {
  for (int gap = 0; gap < 2; ++gap) {  // a loop that ends in one may begin in another
    const double before_s = m_playback.cursor_s;
    const auto here = m_history->at(before_s);
    const auto next = m_history->stepped(before_s, 1);
    if (!here || !next || m_playback.state != Playback::State::Playing) return;
    m_playback.pass_over_gap(here->time_s, next->time_s);
    if (m_playback.state == Playback::State::Parked) emit nothingToPlay();
    if (m_playback.cursor_s == before_s) return;
  }
}

bool FrameTicker::waitsForPicture() {
  return m_pictures && m_pictures() == m_picturesWhenShown && m_sinceShown.elapsed() < longest_wait_ms;
}

void FrameTicker::measure(double played_s, double elapsed_s) {
  m_played_s += played_s;
  m_elapsed_s += elapsed_s;
  if (m_elapsed_s < measured_over_s) return;
  m_achieved = m_played_s / m_elapsed_s;
  m_played_s = m_elapsed_s = 0;
}

/// A request: shown after the pending events, which may include a newer request.
void FrameTicker::changed() {
  m_achieved = std::abs(m_playback.speed);
  m_played_s = m_elapsed_s = 0;
  m_panelsNow = m_panelsNow || !m_scrubbing;
  if (m_history && !m_soon.isActive()) m_soon.start();
  emit playbackAsked();
}

void FrameTicker::askForPanels() {
  m_panelsSoon = true;
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
  m_playback.seek(m_frames_hz > 0 ? std::round(time_s * m_frames_hz) / m_frames_hz : time_s);
  changed();
}

QString FrameTicker::goTo(const TimePlace& place) {
  if (!m_history) return "Nothing is open yet";
  const auto time_s = find_time(place, *m_history, m_playback.cursor_s);
  if (!time_s) return words(time_s.error());
  seek(*time_s);
  return {};
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
  m_playback.set_speed(factor);
  changed();
}

void FrameTicker::changeSpeed(int steps) {
  m_playback.change_speed(steps);
  changed();
}

void FrameTicker::setEveryFrame(bool on) {
  m_playback.every_frame = on;
  changed();
}

void FrameTicker::setLoop(bool on) {
  m_playback.loop = on;
  changed();
}

void FrameTicker::setRepeat(Playback::Repeat repeat) {
  m_playback.repeat = repeat;
  m_playback.loop = true;
  changed();
}

void FrameTicker::changeEnds(const std::function<void()>& change, int drag) {
  const Playback::Ends before = m_playback.ends();
  change();
  changed();
  const Playback::Ends after = m_playback.ends();
  if (after != before) emit endsChanged(before, after, drag);
}

void FrameTicker::setIn() {
  changeEnds([this] { m_playback.set_in(); });
}

void FrameTicker::setOut() {
  changeEnds([this] { m_playback.set_out(); });
}

void FrameTicker::clearIn() {
  changeEnds([this] { m_playback.clear_in(); });
}

void FrameTicker::clearOut() {
  changeEnds([this] { m_playback.clear_out(); });
}

void FrameTicker::setRange(double from_s, double to_s, int drag) {
  changeEnds([this, from_s, to_s] { m_playback.set_range(from_s, to_s); }, drag);
}

void FrameTicker::restoreEnds(const Playback::Ends& ends) {
  m_playback.set_ends(ends);
  changed();
}

void FrameTicker::shuttle(int direction) {
  m_playback.shuttle(direction);
  changed();
}

void FrameTicker::setScrubbing(bool on) {
  m_scrubbing = on;
  if (!on) changed();
}

}  // namespace abrazo::app
