#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/session/file/recording_facts.hpp"
#include "core/session/file/session_edit.hpp"
#include "core/session/frames/frame_listener.hpp"
#include "core/session/frames/frame_store.hpp"
#include "core/session/frames/markers.hpp"
#include "core/session/frames/take_span.hpp"
#include "core/stream/receive/stream_receiver.hpp"

namespace abrazo {

struct Project;

/// Writes a running session into a session file on a separate thread: received poses, settings, decisions and
/// every result. At most the last `commit_interval_s` and the write in progress are not yet on disk. All
/// functions except `finish` and `flush` return immediately. Thread-safe.
class Recorder : public FrameListener {
 public:
  /// Creates the file, or continues one that a recorder wrote: times and frame indices then follow those in
  /// the file.
  static Result<std::shared_ptr<Recorder>> open(const std::string& path, const RecordingFacts& facts,
                                                const RecorderOptions& options = {});

  /// For a StreamReceiver: records a raw pose of any performer.
  virtual void pose_received(const ReceivedPose& pose) = 0;

  /// The following frames belong to a take of this name, until `end_take`; all frames are recorded either
  /// way. Ends an open take.
  virtual void begin_take(const std::string& name) = 0;
  virtual void end_take() = 0;

  /// Replaces the markers of this session.
  virtual void set_markers(const Markers& markers) = 0;
  /// Replaces the project in the same file with the next write.
  virtual void save_project(std::shared_ptr<const Project> project) = 0;
  /// Edits takes of the file, also of previous runs, by the names they have when this is written.
  virtual void edit_takes(const TakeEdits& edits) = 0;
  /// Sets the file of a library that frames will name, other than that of RecordingFacts.
  virtual void set_library_path(const std::shared_ptr<const MotionLibrary>& library,
                                const std::string& path) = 0;

  struct State {
    std::string path;
    std::uint64_t frames = 0, poses = 0;
    std::uint64_t bytes = 0;       ///< on the disk, with the log that goes into the file
    std::uint64_t file_bytes = 0;  ///< of the file with all that was written; never falls
    double behind_s = 0;           ///< age of the oldest frame that is not on disk yet
    std::string take;              ///< open take; empty = none
    TakeSpan take_span;            ///< of the open take; of the last one after its end
    std::string failure;     ///< why frames are being lost: the disk is full or the file was deleted. Empty
                             ///< again once writing continues
    std::uint64_t lost = 0;  ///< frames and poses that will never be on disk
  };
  virtual State state() const = 0;

  /// The written frames, readable during recording, with this session's times and indices. For the history's
  /// store.
  virtual std::shared_ptr<const FrameStore> store() const = 0;

  /// Waits until everything queued is on disk. An Error if it could not be written
  virtual Status flush() = 0;
  /// Waits until everything is on disk, with the library's fingerprint, and closes the file. An Error says
  /// what failed
  virtual Status finish() = 0;
};

}  // namespace abrazo
