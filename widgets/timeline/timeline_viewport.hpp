#pragma once

#include <algorithm>

#include "core/session/frames/playback.hpp"
#include "widgets/timeline/timeline_axis.hpp"

namespace abrazo::widgets {

/// The time span of the timeline. Follows the live end or the cursor until moved by hand; new frames never
/// move it otherwise. Independent of Qt.
class TimelineViewport {
 public:
  const TimelineAxis& axis() const { return axis_; }
  /// The whole range over the same width, for the overview.
  TimelineAxis whole() const {
    TimelineAxis whole = axis_;
    whole.first_s = playback_.first_s;
    whole.span_s = std::max(playback_.last_s - playback_.first_s, TimelineAxis::shortest_s);
    return whole;
  }
  void set_place(double left_px, double width_px) {
    axis_.left_px = left_px;
    axis_.width_px = width_px;
  }
  /// Whether a part of the range is outside.
  bool is_partial() const {
    return playback_.first_s < axis_.first_s - 1e-6 || playback_.last_s > axis_.last_s() + 1e-6;
  }
  /// Was moved by hand and no longer follows.
  bool is_detached() const { return !attached_; }

  /// Updates from the playback. A seek, playing and following bring the view back to the cursor.
  /// @param held  the cursor is being dragged: the view stays under the pointer
  void show(const Playback& playback, bool held = false) {
    const bool following = playback.state == Playback::State::Following;
    const bool moved = !following && playback.cursor_s != playback_.cursor_s;
    if (playback.state != playback_.state || (moved && !held)) attached_ = true;
    const bool asked = moved || playback.state != playback_.state;
    playback_ = playback;
    if (all_) return fit();
    if (!attached_) return;
    if (following)
      axis_.follow(playback.first_s, playback.last_s);
    else if (asked && !held)
      axis_.reveal(playback.cursor_s);
  }

  /// Shows everything, including frames to come, until zoomed or moved.
  void show_all() {
    all_ = true;
    attached_ = true;
    fit();
  }

  void show_range(double from_s, double to_s) {
    if (to_s <= from_s) return;
    all_ = false;
    axis_.show(from_s, to_s);
    settle_attachment();
  }

  /// Zooms about `fixed_s`, or about the live end while following.
  void zoom(double factor, double fixed_s) {
    all_ = false;
    const bool at_live_end = follows();
    axis_.zoom(factor, fixed_s);
    keep_in_reach();
    at_live_end ? axis_.follow(playback_.first_s, playback_.last_s) : settle_attachment();
  }

  /// Pans until `time_s` is in the middle.
  void centre(double time_s) { pan(time_s - axis_.span_s / 2 - axis_.first_s); }

  /// Moves by hand; reaching the live end while it is followed resumes following.
  void pan(double by_s) {
    all_ = false;
    axis_.first_s += by_s;
    keep_in_reach();
    settle_attachment();
  }

 private:
  bool follows() const { return attached_ && playback_.state == Playback::State::Following; }

  void fit() {
    constexpr double least_s = 1;
    axis_.show(playback_.first_s, std::max(playback_.last_s, playback_.first_s + least_s));
  }

  /// Detaches if moved by hand away from the cursor.
  void settle_attachment() {
    attached_ = playback_.cursor_s >= axis_.first_s && playback_.cursor_s <= axis_.last_s();
  }

  /// Keeps at least a tenth of the view filled.
  void keep_in_reach() {
    const double some_s = 0.1 * axis_.span_s;
    const double lowest = playback_.first_s + some_s - axis_.span_s, highest = playback_.last_s - some_s;
    axis_.first_s = std::clamp(axis_.first_s, std::min(lowest, highest), std::max(lowest, highest));
  }

  TimelineAxis axis_;
  Playback playback_;
  bool attached_ = true;
  bool all_ = false;
};

}  // namespace abrazo::widgets
