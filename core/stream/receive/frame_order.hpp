#pragma once

#include <compare>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>

namespace abrazo {

/// Place of a frame in the sender's order. A restarted sender begins a new epoch.
struct SequencePlace {
  std::int64_t epoch = 0;
  double value = 0;           ///< the sender's counter, or its time [s], or the number of arrivals
  std::uint64_t arrival = 0;  ///< tells frames of the same value apart
  auto operator<=>(const SequencePlace&) const = default;
};

/// Tells from counter, time and content of the frames of one performer what is new, what came out of order
/// or twice, what was lost, and when the sender restarted. By the counter where there is one, else by the
/// sender's time, else as they come.
class FrameOrder {
 public:
  enum class Kind {
    Next,       ///< newer than all before
    Earlier,    ///< older than the newest, not seen before
    Repeated,   ///< seen before
    Stray,      ///< from another time: of a sender that restarts, or out of nowhere
    Restarted,  ///< newer than all before, since the sender restarted
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

  /// Frames that the sender counted and that never came.
  std::uint64_t lost() const { return lost_; }

  /// Positions and time that differ less are not told apart: a frame that comes again does so within it.
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
  std::set<double> missing_;        ///< counters not (yet) seen
  std::deque<std::int64_t> steps_;  ///< of the counter, newest last
  std::int64_t stride_ = 1;         ///< by which the sender counts
  std::uint64_t lost_ = 0;
  int strays_ = 0;
  double last_stray_ = 0;
};

}  // namespace abrazo
