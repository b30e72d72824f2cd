#pragma once

#include <compare>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>

namespace abrazo {

/// Position of a frame in the sender's order. A restarted sender begins a new epoch.
struct SequencePlace {
  std::int64_t epoch = 0;
  double value = 0;           ///< the sender's counter, or its time [s], or the number of arrivals
  std::uint64_t arrival = 0;  ///< distinguishes frames of equal value
  auto operator<=>(const SequencePlace&) const = default;
};

/// Classifies the frames of one performer as new, out of order, repeated or lost, and detects restarts of the
/// sender. Uses the counter if there is one, else the sender's time, else the order of arrival.
class FrameOrder {
 public:
  enum class Kind {
    Next,       ///< newer than all before
    Earlier,    ///< older than the newest, not seen before
    Repeated,   ///< seen before
    Stray,      ///< from an unrelated time: perhaps a restarting sender
    Restarted,  ///< newer than all before, because the sender restarted
  };
  struct Placed {
    Kind kind = Kind::Next;
    SequencePlace place;
  };
  /// What identifies a frame; `content` is a hash of its positions.
  struct Frame {
    std::optional<std::int64_t> counter;
    std::optional<double> sender_time_s;
    std::uint64_t content = 0;
    double arrived_s = 0;
  };
  Placed place(const Frame& frame);

  /// Frames counted by the sender that never arrived.
  std::uint64_t lost() const { return lost_; }

  /// A frame is recognised as repeated within this time.
  static constexpr double memory_s = 0.75;
  static constexpr int strays_of_a_restart = 3;

 private:
  enum class Key { None, Counter, Time };
  struct Seen {
    std::uint64_t content;
    double arrived_s;
  };
  enum class Recollection { Unknown, Same, Other };

  Recollection recall(double value, const Frame& frame) const;
  bool is_from_another_time(double value, const Frame& frame) const;
  bool is_believable_step(double value, const Frame& frame) const;
  Placed next(double value, const Frame& frame);
  Placed stray(double value, const Frame& frame);
  Placed begin(double value, const Frame& frame, Kind kind);
  void remember(double value, const Frame& frame);
  void count_gap(std::int64_t step, double newest);
  std::int64_t usual_step() const;

  Key key_ = Key::None;
  bool started_ = false;
  std::int64_t epoch_ = 0;
  std::uint64_t arrivals_ = 0;
  double newest_ = 0;
  double newest_arrived_s_ = 0;
  std::optional<double> newest_time_s_;
  std::multimap<double, Seen> seen_;
  std::set<double> missing_;        ///< counters not seen (yet)
  std::deque<std::int64_t> steps_;  ///< of the counter, newest last
  std::int64_t stride_ = 1;         ///< step of the sender's counter
  std::uint64_t lost_ = 0;
  int strays_ = 0;
  double last_stray_ = 0;
};

}  // namespace abrazo
