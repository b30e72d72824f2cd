#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "core/stream/receive/frame_order.hpp"
#include "core/stream/receive/pose_source.hpp"

namespace abrazo {

/// Delays the poses of one performer by a fixed time, so that poses delivered unevenly or out of order come
/// out evenly and in order. Without a delay it delivers immediately. Never delivers a pose older than a
/// previously due one. Bounded.
class JitterBuffer {
 public:
  static constexpr double longest_delay_s = 0.5;

  explicit JitterBuffer(double delay_s = 0) { set_delay(delay_s); }
  /// Clamped to 0..0.5 s.
  void set_delay(double delay_s);
  double delay_s() const { return delay_s_; }

  struct Entry {
    SequencePlace place;
    double sent_s = 0;  ///< session clock; due after the delay
    SourcePose pose;
  };
  enum class Fate {
    Taken,
    Reordered,  ///< arrived after a newer one, but in time
    Late,       ///< arrived after a newer one was due: dropped
  };
  Fate push(Entry entry, double now_s);

  /// Position of a reader: it has seen everything before.
  struct Cursor {
    std::uint64_t next = 0;
  };
  /// A cursor at the newest due pose, for a new reader.
  Cursor now(double now_s);
  /// The oldest due pose at or after the cursor, and the number dropped before it.
  struct Due {
    const Entry* entry = nullptr;
    std::uint64_t number = 0;
  };
  std::optional<Due> due_after(const Cursor& cursor, double now_s);
  /// Due time of the pose at the cursor; none if it has not arrived.
  std::optional<double> next_due_s(const Cursor& cursor) const;

 private:
  void play_until(double now_s);

  double delay_s_ = 0;
  std::deque<Entry> entries_;            ///< in the sender's order
  std::uint64_t forgotten_ = 0;          ///< index of the first entry
  std::optional<SequencePlace> played_;  ///< newest that was due
};

}  // namespace abrazo
