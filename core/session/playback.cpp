#include "core/session/playback.hpp"

#include <algorithm>
#include <cmath>

namespace abrazo {

void Playback::extend(double first, double last) {
  first_s = first;
  last_s = std::max(first, last);
  if (state == State::Following) cursor_s = last_s;
  cursor_s = std::clamp(cursor_s, first_s, last_s);
}

void Playback::advance(double elapsed_s) {
  if (state != State::Playing) return;
  cursor_s += speed * elapsed_s;
  if (loop && out_s > in_s) {
    const double length = out_s - in_s;
    if (cursor_s < in_s || cursor_s >= out_s)
      cursor_s = in_s + std::fmod(std::fmod(cursor_s - in_s, length) + length, length);
    cursor_s = std::clamp(cursor_s, first_s, last_s);
    return;
  }
  if (cursor_s >= last_s) {
    cursor_s = last_s;
    state = State::Following;
  } else if (cursor_s <= first_s && speed < 0) {
    cursor_s = first_s;
    state = State::Parked;
  }
}

void Playback::seek(double time_s) {
  cursor_s = std::clamp(time_s, first_s, last_s);
  state = State::Parked;
}

void Playback::play() {
  if (state == State::Playing) return;
  if (cursor_s >= last_s && speed > 0) cursor_s = first_s;
  state = State::Playing;
}

void Playback::pause() {
  state = State::Parked;
}

void Playback::toggle() {
  if (state == State::Parked)
    play();
  else
    pause();
}

void Playback::follow() {
  state = State::Following;
  speed = 1;
  cursor_s = last_s;
}

}  // namespace abrazo
