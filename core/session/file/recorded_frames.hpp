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

/// The frames of a session file as a history asks for them, over a connection of its own: also while the file
/// is recorded. What needs the library (mesh, selected pair, residuals of edges) is there for frames that
/// were solved with the given one; morph steps are not kept. Keeps the frames read last in memory.
class RecordedFrames : public FrameStore {
 public:
  /// @param library  that the session was solved with, or null
  static Result<std::shared_ptr<RecordedFrames>> open(const std::string& path,
                                                      std::shared_ptr<const MotionLibrary> library = nullptr);

  /// Over a connection that is open already.
  static Result<std::shared_ptr<RecordedFrames>> over(SessionDatabase database);

  /// How a recorder's own times and indices become those of the file; only frames from `first_frame` on are
  /// seen.
  struct Origin {
    double offset_s = 0;
    std::uint64_t offset_frames = 0;
    std::uint64_t first_frame = 0;  ///< in the file
  };
  static Result<std::shared_ptr<RecordedFrames>> open(const std::string& path, const Origin& origin);

  /// Another library that frames were solved with. Goes through all of it: a million pairs take seconds.
  virtual void add_library(std::shared_ptr<const MotionLibrary> library) = 0;
  /// The library that a row of the file means, said by who writes it.
  virtual void set_library(std::int64_t row, std::shared_ptr<const MotionLibrary> library) = 0;

  /// Runs something while there is no connection to the file, so that it can become one file; who reads
  /// meanwhile waits.
  virtual Status without_connection(const std::function<Status()>& run) = 0;

  /// Frames that could not be read since it was opened, and why the first could not.
  virtual std::uint64_t damaged() const = 0;
  virtual std::string damage() const = 0;
};

}  // namespace abrazo
