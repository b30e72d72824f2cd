#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "core/session/frames/frame_range.hpp"
#include "core/session/frames/frame_snapshot.hpp"
#include "core/session/frames/frame_store.hpp"

namespace abrazo {

/// The solved frames of a session, oldest first: those of the last while in memory, bounded in bytes; those
/// before from a store, when there is one. Appended by the solver thread, read by any; only readers who ask
/// for what memory no longer has wait for the store.
class FrameHistory {
 public:
  explicit FrameHistory(std::size_t max_bytes = std::size_t{512} << 20);

  void append(FrameSnapshotPtr frame);
  /// Forgets the frames in memory.
  void clear();

  /// Where frames are kept that memory does not have, or null. They have the same times and indices; those
  /// that are in both are taken from memory.
  void set_store(std::shared_ptr<const FrameStore> store);
  std::shared_ptr<const FrameStore> store() const;

  struct Span {
    double first_s = 0;  ///< oldest kept, in memory or in the store
    double last_s = 0;
    std::size_t frames = 0;         ///< in memory
    std::size_t evicted = 0;        ///< dropped from the old end of memory because of the bound
    std::size_t bytes = 0;          ///< in memory
    double memory_first_s = 0;      ///< from here on frames are in memory; after last_s when none is
    std::uint64_t stored = 0;       ///< frames before that, which only the store has
    std::uint64_t first_index = 0;  ///< of the oldest kept
  };
  Span span() const;

  /// So many frames of the store `since` gives at most: enough for a timeline or a plot.
  static constexpr std::size_t overview_frames = 4096;
  static constexpr std::size_t all_frames = std::numeric_limits<std::size_t>::max();

  /// The frame shown at a time: the last one not after it; the oldest kept when all are after; null when
  /// empty.
  FrameSnapshotPtr at(double time_s) const;
  /// The frame `steps` before (negative) or after the one shown at `time_s`, held at the ends.
  FrameSnapshotPtr stepped(double time_s, int steps) const;
  /// All frames in [from_s, to_s]. @param most  when the store has more of them they are evenly thinned to so
  /// many; those in memory all come
  std::vector<FrameSnapshotPtr> range(double from_s, double to_s, std::size_t most = all_frames) const;
  /// The same, however many they are: held are those in memory and a piece of the others.
  FrameRange stretch(double from_s, double to_s) const;
  /// The frames in [from_s, to_s], after those back to the last one that has the synthesizer's state.
  struct SolvableAgain {
    std::vector<FrameSnapshotPtr> run_up;  ///< come before the range; the first has a state
    FrameRange frames;      ///< the first has a state where there is no run-up; empty when none can be had
    bool is_short = false;  ///< the range begins later than asked: what it needs is no longer kept
  };
  SolvableAgain solvable_again(double from_s, double to_s) const;
  /// All frames whose index is at least `index`: what is new since a reader looked last. Of those that only
  /// the store has, at most `overview_frames`, evenly thinned.
  std::vector<FrameSnapshotPtr> since(std::uint64_t index) const;

 private:
  std::pair<Span, std::shared_ptr<const FrameStore>> view() const;
  FrameSnapshotPtr remembered(double time_s, int steps, bool only_inside) const;
  FrameSnapshotPtr stored_step(const FrameStore& store, double time_s, int steps) const;
  /// What memory has of [from_s, to_s], and what only the store has before it.
  struct Parts {
    std::vector<FrameSnapshotPtr> remembered;
    std::shared_ptr<const FrameStore> store;  ///< null when nothing of it is wanted
    double stored_to_s = 0;                   ///< its frames end there
    std::uint64_t first_index = 0;            ///< of the oldest in memory; those from there on are not wanted
  };
  Parts parts(double from_s, double to_s) const;
  std::vector<FrameSnapshotPtr> run_up(const FrameSnapshot& to) const;
  std::ptrdiff_t position_at(double time_s) const;
  std::ptrdiff_t first_not_before(double time_s) const;

  mutable std::mutex mutex_;
  std::deque<FrameSnapshotPtr> frames_;
  std::shared_ptr<const FrameStore> store_;
  std::size_t max_bytes_;
  std::size_t bytes_ = 0;
  std::size_t evicted_ = 0;
};

/// Memory that a snapshot holds, with its vectors [bytes].
std::size_t size_of(const FrameSnapshot& frame);

}  // namespace abrazo
