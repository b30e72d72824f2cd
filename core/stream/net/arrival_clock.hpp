#pragma once

namespace abrazo {

/// When a packet came, on the session's clock. The kernel stamps on the wall clock, which people and time
/// servers set: only a packet's age is taken from it, and not that of one that waited while it was set.
class ArrivalClock {
 public:
  /// @param stamp_s, wall_s  when the packet came and now, on the wall clock
  /// @param now_s            now, on the session's clock
  /// @return session time; `now_s` where it cannot be known. Never after it.
  double arrived_s(double stamp_s, double wall_s, double now_s);

 private:
  bool is_first_ = true;
  double ahead_s_ = 0;  ///< of the wall clock before the session's, at the last reading
  double read_s_ = 0;   ///< session time of it
  double set_s_ = 0;    ///< no stamp from before this is of the wall clock as it goes now
};

}  // namespace abrazo
