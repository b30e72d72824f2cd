#pragma once

#include <deque>
#include <optional>

namespace abrazo {

/// Sender's clock -> session clock. The packet with the smallest delay of the last two seconds gives the
/// offset
///   offset = min (arrived - sent)
/// so that network delays cancel and a slow drift is followed. Expects packets in the sender's order; only
/// query the time of packets that arrive after a newer one.
class SenderClock {
 public:
  static constexpr double window_s = 2;
  static constexpr double jump_s = 0.3;    ///< a difference that network delay does not explain
  static constexpr double patience_s = 1;  ///< a larger delay for this long means another clock

  /// @return whether the sender's clock jumped, backwards or forwards
  bool take(double sent_s, double arrived_s);
  /// Session time of sending; never later than `arrived_s` of a packet taken. None before `take`.
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
