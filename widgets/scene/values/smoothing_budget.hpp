#pragma once

namespace abrazo::widgets {

/// Whether the next picture can afford its edges smoothed. On a slow renderer a moving picture goes without,
/// so that it keeps its rate; one that stands still always has them.
class SmoothingBudget {
 public:
  /// From the start of a picture to the screen; the panels need their share of the 33 ms.
  static constexpr double affordable_ms = 14;

  bool wants_smoothing(bool moving) const { return !moving || smoothed_ms_ < affordable_ms; }

  void took(bool smoothed, double ms) {
    // Estimates fade while they are not renewed, so that a machine that was busy for a while is tried again.
    if (smoothed)
      smoothed_ms_ = smoothed_ms_ == 0 ? ms : 0.8 * smoothed_ms_ + 0.2 * ms;
    else
      smoothed_ms_ *= 0.998;
  }

 private:
  double smoothed_ms_ = 0;
};

}  // namespace abrazo::widgets
