#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "core/base/result.hpp"
#include "core/session/frames/frame_store.hpp"

namespace abrazo {

class MotionLibrary;
class SessionDatabase;

/// The frames of a session file as a FrameStore, over a separate connection, also during recording. Members
/// that need the library (mesh, selected pair, residuals of edges) are set for frames solved with a known
/// library; morph steps are not stored. Caches the frames read last.
class RecordedFrames : public FrameStore {
 public:
  /// @param library with which the session was solved, or null
  static Result<std::shared_ptr<RecordedFrames>> open(const std::string& path,
                                                      std::shared_ptr<const MotionLibrary> library = nullptr);

  /// Uses a connection that is already open.
  static Result<std::shared_ptr<RecordedFrames>> over(SessionDatabase database);

  /// Maps a recorder's times and indices to those of the file; frames before `first_frame` are hidden.
  struct Origin {
    double offset_s = 0;
    std::uint64_t offset_frames = 0;
    std::uint64_t first_frame = 0;  ///< in the file
  };
  static Result<std::shared_ptr<RecordedFrames>> open(const std::string& path, const Origin& origin);

  /// Adds a library with which frames were solved. Hashes it: a million pairs take seconds.
  virtual void add_library(std::shared_ptr<const MotionLibrary> library) = 0;
  /// Sets the library of a row of the file; called by the writer.
  virtual void set_library(std::int64_t row, std::shared_ptr<const MotionLibrary> library) = 0;
  /// Hides frames before one, by the index of Origin; called by the writer at its first. The file may get
  /// earlier frames when it is saved with the history, and those are not this recorder's.
  virtual void set_first_frame(std::uint64_t index) = 0;

  /// Runs a function while the connection is closed, so that the database can become one file; readers wait
  /// meanwhile.
  virtual Status without_connection(const std::function<Status()>& run) = 0;

  /// Number of unreadable frames since opening, and the reason for the first.
  virtual std::uint64_t damaged() const = 0;
  virtual std::string damage() const = 0;
};

}  // namespace abrazo
