#pragma once

namespace abrazo {

/// Converts arrival times of packets to the session's clock. The kernel stamps packets with the wall clock,
/// which people and time servers adjust: only a packet's age is used, and not if the clock was adjusted while
/// the packet waited.
class ArrivalClock {
 public:
  /// @param stamp_s, wall_s arrival and present time on the wall clock
  /// @param now_s present time on the session's clock
  /// @return session time; `now_s` if unknown. Never later than it.
  double arrived_s(double stamp_s, double wall_s, double now_s);

 private:
  bool is_first_ = true;
  double ahead_s_ = 0;  ///< wall clock minus session clock at the last reading
  double read_s_ = 0;   ///< session time of the last reading
  double set_s_ = 0;    ///< stamps before this are from before an adjustment
};

}  // namespace abrazo
