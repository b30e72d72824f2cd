#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/base/result.hpp"
#include "core/session/file/recording_facts.hpp"
#include "core/session/frames/frame_listener.hpp"
#include "core/session/frames/frame_store.hpp"

namespace abrazo {

struct HistoryBound {
  std::uint64_t bytes = std::uint64_t{4} << 30;  ///< of all files together; the oldest is removed above it
  double tend_every_s = 0.5;  ///< on a thread of the keeper; 0 = only when `tend` is called
};

/// Keeps the frames of a running session on disk for its history: several session files in a folder, each an
/// eighth of the bound. Pauses while a recorder writes the frames. Thread-safe; no function waits
/// for the disk except `open`, `go_on`, `tend` and `remove`.
class HistoryKeeper : public FrameListener {
 public:
  /// @param folder created if missing; belongs to the keeper alone
  static Result<std::shared_ptr<HistoryKeeper>> open(const std::string& folder, const RecordingFacts& facts,
                                                     const HistoryBound& bound = {});

  /// Rests once these frames come in: a recorder writes them from now on.
  virtual void rest(std::shared_ptr<const FrameStore> recorded) = 0;
  /// Ends the rest. An Error if no file can be made; frames are then kept in memory only
  virtual Status go_on() = 0;
  /// Begins another file if the present one is large enough, and removes the oldest above the bound.
  virtual void tend() = 0;
  virtual void set_bound(std::uint64_t bytes) = 0;

  struct State {
    std::uint64_t bytes = 0;          ///< on disk
    std::uint64_t bound = 0;          ///< bytes
    std::uint64_t removed_files = 0;  ///< because of the bound
    std::string failure;              ///< why frames are not on disk; empty again once they are
  };
  virtual State state() const = 0;
  /// Length of the frames after a time in its own files [s]: without what recorders wrote while it rested.
  /// Waits while the files change.
  virtual double kept_after_s(double time_s) const = 0;
  /// The part of it in which poses of a live performer were answered [s]; a pause of a second ends it.
  virtual double performed_after_s(double time_s) const = 0;
  /// The frames on disk, and those of the recorders during pauses.
  virtual std::shared_ptr<const FrameStore> store() const = 0;

  /// Ends and deletes the files and the folder.
  virtual void remove() = 0;
};

}  // namespace abrazo
