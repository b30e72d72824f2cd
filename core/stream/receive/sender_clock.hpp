#pragma once

#include <deque>
#include <optional>

namespace abrazo {

/// Sender's clock -> session clock. The least delayed packet of the last two seconds gives the offset
///   offset = min (arrived - sent)
/// so that delays of the network fall out and a slow drift is followed. Packets come in the sender's order;
/// what comes after a newer one is only asked about.
class SenderClock {
 public:
  static constexpr double window_s = 2;
  static constexpr double jump_s = 0.3;    ///< a difference that no network explains
  static constexpr double patience_s = 1;  ///< packets so much too late for so long mean another clock

  /// @return whether the sender's clock jumped, backwards or forwards
  bool take(double sent_s, double arrived_s);
  /// When it was sent [session clock]; never later than `arrived_s` of a packet taken. Nothing before `take`.
  std::optional<double> session_time(double sent_s) const;
  void restart();

 private:
  struct Sample {
    double arrived_s, offset_s;
  };
  void begin_with(double sent_s, double arrived_s);

  std::deque<Sample> smallest_;  ///< offsets that may still become the minimum, ascending in both
  double newest_sent_s_ = 0;
  std::optional<double> late_since_s_;
};

}  // namespace abrazo
