#pragma once

#include <deque>
#include <optional>

namespace abrazo {

/// Sender's clock -> session clock. The packet with the smallest delay of the last two seconds gives the
/// offset
///   offset = min (arrived - sent)
/// so that network delays cancel and a slow drift is followed. Expects packets in the sender's order; only
/// query the time of packets that arrive after a newer one.
///
/// The sender's clock is used while it proves itself against arrival. It is in doubt if two frames have one
/// time, if its number is too coarse for the frames (seconds since 1970 in a 32-bit float have steps of 128
/// s), or if it jumps again and again, since it does not count seconds. It is used again when nothing spoke
/// against it for a while.
class SenderClock {
 public:
  enum class Doubt { None, Stands, Coarse, Jumps };
  static constexpr double coarsest_s = 0.004;  ///< steps, a quarter of an interval at 60 Hz
  static constexpr double proof_s = 2;         ///< so long nothing may speak against it
  static constexpr int most_jumps = 2;         ///< within
  static constexpr double jumps_within_s = 10;
  static constexpr double window_s = 2;
  static constexpr double jump_s = 0.3;    ///< a difference that network delay does not explain
  static constexpr double patience_s = 1;  ///< a larger delay for this long means another clock

  /// @return whether the sender's clock jumped, backwards or forwards; not of a clock in doubt
  bool take(double sent_s, double arrived_s);
  /// Session time of sending; never later than `arrived_s` of a packet taken. None before `take`, and of a
  /// clock in doubt.
  std::optional<double> session_time(double sent_s) const;
  Doubt doubt() const { return doubt_; }
  void restart();

 private:
  struct Sample {
    double arrived_s, offset_s;
  };
  void begin_with(double sent_s, double arrived_s);
  bool follow(double sent_s, double arrived_s);
  Doubt doubt_about(double sent_s, double arrived_s, bool jumped);

  std::deque<Sample> smallest_;  ///< offsets that may still become the minimum, ascending in both
  double newest_sent_s_ = 0;
  std::optional<double> late_since_s_;
  std::optional<double> last_sent_s_;
  std::deque<double> jumped_s_;  ///< arrivals at the recent jumps
  Doubt doubt_ = Doubt::None;
  double doubtful_until_s_ = 0;
};

}  // namespace abrazo
