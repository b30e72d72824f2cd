#pragma once

namespace abrazo::widgets {

/// Decides whether the next picture is anti-aliased. On a slow renderer moving pictures are not, to keep
/// their rate; still pictures always are.
class SmoothingBudget {
 public:
  /// Time from the start of a picture to the screen; the panels need the rest of the 33 ms.
  static constexpr double affordable_ms = 14;

  bool wants_smoothing(bool moving) const { return !moving || smoothed_ms_ < affordable_ms; }

  void took(bool smoothed, double ms) {
    // Estimates decay while they are not renewed, so that smoothing is tried again after a busy time.
    if (smoothed)
      smoothed_ms_ = smoothed_ms_ == 0 ? ms : 0.8 * smoothed_ms_ + 0.2 * ms;
    else
      smoothed_ms_ *= 0.998;
  }

 private:
  double smoothed_ms_ = 0;
};

}  // namespace abrazo::widgets
