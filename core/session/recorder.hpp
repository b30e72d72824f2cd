#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/base/result.hpp"
#include "core/session/frame_listener.hpp"
#include "core/session/frame_store.hpp"
#include "core/stream/stream_receiver.hpp"

namespace abrazo {

/// What a recording says of where it came from; kept in the session file.
struct RecordingFacts {
  std::string library_path;  ///< as it was opened; the file keeps it relative to itself where it can
  std::string library_name;
  std::uint64_t library_pairs = 0;
  std::string input;  ///< URI or clip
};

/// Writes a running session into a session file, on a thread of its own: everything that was received, the
/// settings and decisions, every result. At most half a second is not yet on disk.
class Recorder : public FrameListener {
 public:
  /// Creates the file, or goes on in one that a recorder wrote.
  static Result<std::shared_ptr<Recorder>> open(const std::string& path, const RecordingFacts& facts);

  /// Listener of a StreamReceiver: a raw pose of any performer.
  virtual void pose_received(const ReceivedPose& pose) = 0;

  /// From here on the frames belong to a take of this name, till `end_take`; all are kept either way.
  virtual void begin_take(const std::string& name) = 0;
  virtual void end_take() = 0;

  struct State {
    std::string path;
    std::uint64_t frames = 0, poses = 0, bytes = 0;
    double behind_s = 0;  ///< age of the oldest frame that is not on disk yet
    std::string take;     ///< being recorded; empty = none
    std::string failure;  ///< why nothing more is written (disk full): frames are lost from then on
    std::uint64_t lost = 0;
  };
  virtual State state() const = 0;

  /// What is already written, readable while it goes on: for a history that reaches back to the disk.
  virtual std::shared_ptr<const FrameStore> store() const = 0;

  /// Waits till all is on disk and closes the file. @return what went wrong
  virtual Status finish() = 0;
};

}  // namespace abrazo
