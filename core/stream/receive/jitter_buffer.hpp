#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "core/stream/receive/frame_order.hpp"
#include "core/stream/receive/pose_source.hpp"

namespace abrazo {

/// Holds the poses of one performer back for a fixed time, so that what the network delivers unevenly or out
/// of order comes out evenly and in order. Without a delay it delivers immediately. Never gives a pose that
/// is older than one that was due before. Bounded.
class JitterBuffer {
 public:
  static constexpr double longest_delay_s = 0.5;

  explicit JitterBuffer(double delay_s = 0) { set_delay(delay_s); }
  /// Clamped to 0..0.5 s.
  void set_delay(double delay_s);
  double delay_s() const { return delay_s_; }

  struct Entry {
    SequencePlace place;
    double sent_s = 0;  ///< on the session clock; due a delay later
    SourcePose pose;
  };
  enum class Fate {
    Taken,
    Reordered,  ///< came after a newer one, but in time
    Late,       ///< came after a newer one was due: left out
  };
  Fate push(Entry entry, double now_s);

  /// Where a reader stands: it has seen all before this.
  struct Cursor {
    std::uint64_t next = 0;
  };
  /// At the newest pose that is due, so that a reader begins with that.
  Cursor now(double now_s);
  /// The oldest pose at or after the cursor that is due, and how many were forgotten before it.
  struct Due {
    const Entry* entry = nullptr;
    std::uint64_t number = 0;
  };
  std::optional<Due> due_after(const Cursor& cursor, double now_s);
  /// When the pose at the cursor is due; nothing when it has not come.
  std::optional<double> next_due_s(const Cursor& cursor) const;

 private:
  void play_until(double now_s);

  double delay_s_ = 0;
  std::deque<Entry> entries_;            ///< in the sender's order
  std::uint64_t forgotten_ = 0;          ///< number of the first entry
  std::optional<SequencePlace> played_;  ///< newest that was due
};

}  // namespace abrazo
