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
    if (smoothed)
      smoothed_ms_ = smoothed_ms_ < affordable_ms ? 0.8 * smoothed_ms_ + 0.2 * ms : ms;
    else if (ms < affordable_ms)
      smoothed_ms_ *= 0.998;  // it is tried again, after a busy time as well; smoothing only adds to the rest
  }

 private:
  double smoothed_ms_ = affordable_ms;  ///< unknown: tried when a picture without it was quick
};

}  // namespace abrazo::widgets
