#include "core/session/frames/playback.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace abrazo {
namespace {

constexpr std::array usual_speeds = {0.01, 0.02, 0.05, 0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 10.0};

}  // namespace

void Playback::extend(double first, double last) {
  first_s = first;
  last_s = std::max(first, last);
  if (state == State::Following) cursor_s = last_s;
  cursor_s = std::clamp(cursor_s, first_s, last_s);
  settle_range();
}

void Playback::advance(double elapsed_s) {
  if (state != State::Playing) return;
  cursor_s += speed * elapsed_s;
  if (loop) {
    const Range all{first_s, last_s};
    const Range repeated = range().value_or(all);
    if (repeated.length_s() > 0) return wrap(repeated);
  }
  if (cursor_s >= last_s && !is_live) {
    cursor_s = last_s;
    if (speed > 0) state = State::Parked;
  } else if (cursor_s >= last_s) {
    // Slower than what comes in, it only waits there for more.
    speed < 1 ? void(cursor_s = last_s) : follow();
  } else if (cursor_s <= first_s && speed < 0) {
    cursor_s = first_s;
    state = State::Parked;
  }
}

double Playback::advance_to_next(double elapsed_s, double next_frame_s) {
  const double distance = (next_frame_s - cursor_s) / speed;
  const double taken = distance > 0 ? std::min(elapsed_s, distance) : elapsed_s;
  advance(taken);
  constexpr double rounding_s = 1e-9;  // must not leave the cursor just before the frame
  if (std::abs(cursor_s - next_frame_s) < rounding_s) cursor_s = next_frame_s;
  return taken;
}

void Playback::pass_over_gap(double from_s, double to_s) {
  const double shown_to_s = from_s + gap_shown_s;
  if (state != State::Playing || to_s - from_s <= longest_gap_s) return;
  if (cursor_s <= shown_to_s || cursor_s >= to_s) return;
  const bool forward = speed > 0;
  const auto repeated = loop ? range() : std::nullopt;
  const bool has_before = !repeated || repeated->from_s <= shown_to_s;
  const bool has_after = !repeated || repeated->to_s >= to_s;
  if (!has_before && !has_after) return pause();
  if (forward ? has_after : has_before) {
    cursor_s = forward ? to_s : shown_to_s;
  } else if (repeat == Repeat::PingPong) {
    speed = -speed;
    cursor_s = forward ? shown_to_s : to_s;
  } else {
    cursor_s = forward ? repeated->from_s : repeated->to_s;
  }
}

/// Brings a cursor that left the range back into it, however far it went.
void Playback::wrap(const Range& range) {
  if (cursor_s >= range.from_s && cursor_s < range.to_s) return;
  const double length = range.length_s(), beyond = cursor_s - range.from_s;
  const double period = repeat == Repeat::Loop ? length : 2 * length;  // there and back again
  const double phase = std::fmod(std::fmod(beyond, period) + period, period);
  cursor_s = range.from_s + std::min(phase, period - (repeat == Repeat::Loop ? 0 : phase));
  const bool turned = std::fmod(std::abs(std::floor(beyond / length)), 2) == 1;
  if (repeat == Repeat::PingPong && turned) speed = -speed;
}

void Playback::seek(double time_s) {
  cursor_s = std::clamp(time_s, first_s, last_s);
  state = State::Parked;
}

void Playback::play() {
  if (state == State::Playing) return;
  const auto repeated = loop ? range() : std::nullopt;
  if (repeated && (cursor_s < repeated->from_s || cursor_s >= repeated->to_s))
    cursor_s = speed > 0 ? repeated->from_s : repeated->to_s;
  else if (cursor_s >= last_s && speed > 0)
    cursor_s = first_s;
  state = State::Playing;
}

void Playback::pause() {
  state = State::Parked;
}

void Playback::toggle() {
  if (state != State::Parked) return pause();
  speed = std::abs(speed);
  play();
}

void Playback::follow() {
  if (!is_live) return seek(last_s);
  state = State::Following;
  speed = 1;
  cursor_s = last_s;
}

void Playback::shuttle(int direction) {
  if (direction == 0) return pause();
  if (direction > 0 && state == State::Following) return;
  const bool same = state == State::Playing && speed * direction > 0;
  const double factor = same ? std::min(2 * std::abs(speed), fastest_shuttle) : 1;
  speed = direction > 0 ? factor : -factor;
  if (state != State::Playing) play();
}

void Playback::change_speed(int steps) {
  constexpr double same = 1e-9;
  double wanted = std::abs(speed);
  for (; steps > 0; --steps) {
    const auto next = std::upper_bound(usual_speeds.begin(), usual_speeds.end(), wanted + same);
    wanted = next == usual_speeds.end() ? fastest : *next;
  }
  for (; steps < 0; ++steps) {
    const auto here = std::lower_bound(usual_speeds.begin(), usual_speeds.end(), wanted - same);
    wanted = here == usual_speeds.begin() ? slowest : *std::prev(here);
  }
  set_speed(wanted);
}

void Playback::set_speed(double factor) {
  const double wanted = std::clamp(std::abs(factor), slowest, fastest);
  if (state == State::Following && wanted < 1) state = State::Playing;
  // Only a cursor that plays backwards now continues backwards.
  speed = state == State::Following ? 1 : state == State::Playing ? std::copysign(wanted, speed) : wanted;
}

void Playback::settle_range() {
  if (!in_set && !out_set) in_s = out_s = 0;
  if (in_set && !out_set) out_s = last_s;
  if (out_set && !in_set) in_s = first_s;
}

void Playback::set_in() {
  in_set = true;
  in_s = cursor_s;
  if (out_set && out_s <= in_s) out_set = false;
  settle_range();
}

void Playback::set_out() {
  out_set = true;
  out_s = cursor_s;
  if (in_set && in_s >= out_s) in_set = false;
  settle_range();
}

void Playback::clear_in() {
  in_set = false;
  settle_range();
}

void Playback::clear_out() {
  out_set = false;
  settle_range();
}

void Playback::set_range(double a_s, double b_s) {
  in_set = out_set = a_s != b_s;
  in_s = std::min(a_s, b_s);
  out_s = std::max(a_s, b_s);
  settle_range();
}

Playback::Ends Playback::ends() const {
  Ends ends;
  if (in_set) ends.in_s = in_s;
  if (out_set) ends.out_s = out_s;
  return ends;
}

void Playback::set_ends(const Ends& ends) {
  in_set = ends.in_s.has_value();
  out_set = ends.out_s.has_value();
  in_s = ends.in_s.value_or(0);
  out_s = ends.out_s.value_or(0);
  settle_range();
}

std::optional<Playback::Range> Playback::range() const {
  const Range left{std::max(in_s, first_s), std::min(out_s, last_s)};
  if (!in_set && !out_set && out_s <= in_s) return std::nullopt;
  if (left.length_s() <= 0) return std::nullopt;
  return left;
}

}  // namespace abrazo
