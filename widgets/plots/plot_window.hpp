#pragma once

#include <algorithm>

#include "core/session/frames/playback.hpp"

namespace abrazo::widgets {

/// The time span of the plots. Follows the live end or the cursor until moved by hand. Independent of Qt.
class PlotWindow {
 public:
  static constexpr double shortest_s = 0.25, longest_s = 3600;

  double from_s() const { return to_s_ - span_s_; }
  double to_s() const { return to_s_; }
  double span_s() const { return span_s_; }
  /// Follows the live end.
  bool follows() const { return attached_ && playback_.state == Playback::State::Following; }
  /// Was moved by hand and no longer follows.
  bool detached() const { return !attached_; }

  /// Updates from the playback. A seek, playing and following bring the window back to the cursor.
  void show(const Playback& playback) {
    const bool asked = playback.state != playback_.state ||
                       (playback.state == Playback::State::Parked && playback.cursor_s != playback_.cursor_s);
    playback_ = playback;
    if (asked) attached_ = true;
    settle();
  }

  /// Back to the live end or the cursor.
  void attach() {
    attached_ = true;
    settle();
  }

  /// Moves by hand; reaching the live end while it is followed resumes following.
  void pan(double by_s) {
    to_s_ += by_s;
    attached_ = playback_.state == Playback::State::Following ? to_s_ >= latest() : is_cursor_within();
    settle();
  }

  /// Scales the span by a factor about `fixed_s`, or about the live end while following.
  void zoom(double factor, double fixed_s) {
    const double wanted = std::clamp(span_s_ * factor, shortest_s, longest_s);
    if (!follows()) {
      to_s_ = fixed_s + (to_s_ - fixed_s) * wanted / span_s_;
      if (playback_.state != Playback::State::Following) attached_ = attached_ && would_show_cursor(wanted);
    }
    span_s_ = wanted;
    settle();
  }

 private:
  double latest() const { return std::max(playback_.last_s, playback_.first_s + span_s_); }
  bool would_show_cursor(double span_s) const {
    return playback_.cursor_s >= to_s_ - span_s && playback_.cursor_s <= to_s_;
  }
  bool is_cursor_within() const { return would_show_cursor(span_s_); }

  void settle() {
    constexpr double kept_in_view = 0.1;
    if (follows())
      to_s_ = latest();
    else if (attached_)
      to_s_ = std::clamp(to_s_, playback_.cursor_s, playback_.cursor_s + span_s_);
    else
      to_s_ = std::clamp(to_s_, playback_.first_s + kept_in_view * span_s_, latest());
  }

  Playback playback_;
  double span_s_ = 20;
  double to_s_ = 0;  ///< right end
  bool attached_ = true;
};

}  // namespace abrazo::widgets
