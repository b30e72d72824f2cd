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

/// The solved frames of a session, oldest first: recent ones in memory, bounded in bytes; older ones from a
/// store if there is one. Appended by the solver thread, read by any thread. Only readers of frames that are
/// no longer in memory wait for the store.
class FrameHistory {
 public:
  explicit FrameHistory(std::size_t max_bytes = std::size_t{512} << 20);

  void append(FrameSnapshotPtr frame);
  /// A frame that was solved again takes the place of the one with its index; a later one is appended.
  void put(FrameSnapshotPtr frame);
  /// Drops the frames in memory.
  void clear();
  /// From now on; the newest frame is always kept.
  void keep_at_most(std::size_t max_bytes);

  /// Sets the store of frames that are not in memory, or null. Its frames have the same times and indices; a
  /// frame in both is taken from memory.
  void set_store(std::shared_ptr<const FrameStore> store);
  std::shared_ptr<const FrameStore> store() const;

  struct Span {
    double first_s = 0;  ///< oldest kept, in memory or in the store
    double last_s = 0;
    std::size_t frames = 0;         ///< in memory
    std::size_t evicted = 0;        ///< oldest frames dropped from memory because of the bound
    std::size_t bytes = 0;          ///< in memory
    double memory_first_s = 0;      ///< frames from this time on are in memory; after last_s if none is
    std::uint64_t stored = 0;       ///< older frames, only in the store
    std::uint64_t first_index = 0;  ///< of the oldest kept
  };
  Span span() const;

  /// Maximum number of frames that `since` reads from the store: enough for a timeline or a plot.
  static constexpr std::size_t overview_frames = 4096;
  static constexpr std::size_t all_frames = std::numeric_limits<std::size_t>::max();

  /// The frame shown at a time: the last one not after it; the oldest if all are later; null if empty.
  FrameSnapshotPtr at(double time_s) const;
  /// The frame `steps` before (negative) or after the one shown at `time_s`, clamped to the ends.
  FrameSnapshotPtr stepped(double time_s, int steps) const;
  /// All frames in [from_s, to_s]. @param most maximum number of frames from the store, evenly thinned;
  /// frames in memory are all returned
  std::vector<FrameSnapshotPtr> range(double from_s, double to_s, std::size_t most = all_frames) const;
  /// Times of all frames in [from_s, to_s], ascending: those of `stretch`, without reading its frames.
  std::vector<double> times(double from_s, double to_s) const;
  /// The frames themselves for any number of them: holds those in memory and one piece of the others.
  FrameRange stretch(double from_s, double to_s) const;
  /// The frames in [from_s, to_s], with the preceding ones back to the last frame that has the synthesizer's
  /// state.
  struct SolvableAgain {
    std::vector<FrameSnapshotPtr> run_up;  ///< frames before the range; the first has a state
    FrameRange frames;      ///< the first has a state if there is no run-up; empty if none can be solved
                            ///< again
    bool is_short = false;  ///< the range begins later than requested: the frames it needs are no longer kept
  };
  SolvableAgain solvable_again(double from_s, double to_s) const;
  /// All frames whose index is at least `index`, for incremental readers. Frames that are only in the store
  /// are evenly thinned to at most `overview_frames`.
  std::vector<FrameSnapshotPtr> since(std::uint64_t index) const;
  /// The same in several calls, for readers that come back and must not wait for the disk: reads at most
  /// `read_at_once` frames of the store, unless it keeps them all in memory. Empty only if there are no more.
  std::vector<FrameSnapshotPtr> next_since(std::uint64_t index) const;
  static constexpr std::size_t read_at_once = 128;
  /// How many frames of the store one of `next_since` stands for at most; 1 if it returns them all.
  std::uint64_t frames_each() const;

 private:
  std::pair<Span, std::shared_ptr<const FrameStore>> view() const;
  FrameSnapshotPtr remembered(double time_s, int steps, bool only_inside) const;
  FrameSnapshotPtr stored_step(const FrameStore& store, double time_s, int steps) const;
  /// The part of [from_s, to_s] in memory, and the earlier part in the store only.
  struct Parts {
    std::vector<FrameSnapshotPtr> remembered;
    std::shared_ptr<const FrameStore> store;  ///< null if it is not needed
    double stored_to_s = 0;                   ///< its frames end there
    std::uint64_t first_index = 0;            ///< of the oldest in memory; the store's frames from it on are
                                              ///< not read
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

/// Memory of a snapshot with its vectors [bytes].
std::size_t size_of(const FrameSnapshot& frame);

}  // namespace abrazo
