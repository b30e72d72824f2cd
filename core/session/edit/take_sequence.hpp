#pragma once

#include <algorithm>
#include <cmath>
#include <string>

namespace abrazo {

/// Recording a take from the key press to its end, with an optional countdown. Plain data and rules; the
/// caller passes the time.
struct TakeSequence {
  enum class Phase { Idle, CountingDown, Recording };
  static constexpr double longest_countdown_s = 10;

  Phase phase = Phase::Idle;
  std::string name;    ///< of the take being counted down or recorded
  double since_s = 0;  ///< session clock; when the phase began
  double countdown_s = 0;

  /// @return whether recording starts immediately; otherwise it starts when `advance` returns true
  bool start(std::string take, double wait_s, double now_s) {
    name = std::move(take);
    since_s = now_s;
    countdown_s = std::clamp(wait_s, 0.0, longest_countdown_s);
    phase = countdown_s > 0 ? Phase::CountingDown : Phase::Recording;
    return phase == Phase::Recording;
  }

  /// Advances the time. @return whether recording begins now
  bool advance(double now_s) {
    if (phase != Phase::CountingDown || now_s - since_s < countdown_s) return false;
    phase = Phase::Recording;
    since_s = now_s;
    return true;
  }

  /// Cancels the countdown or ends the take. @return whether a take was being recorded
  bool stop() {
    const bool recorded = phase == Phase::Recording;
    phase = Phase::Idle;
    return recorded;
  }

  /// The number to show of the countdown: 3, 2, 1; 0 without a countdown.
  int count(double now_s) const {
    if (phase != Phase::CountingDown) return 0;
    return std::max(1, static_cast<int>(std::ceil(countdown_s - (now_s - since_s) - 1e-9)));
  }
  double elapsed_s(double now_s) const { return phase == Phase::Recording ? now_s - since_s : 0; }
};

}  // namespace abrazo
