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
#include "core/stream/receive/stream_receiver.hpp"

namespace abrazo {

struct Project;

/// Writes a running session into a session file, on a thread of its own: everything that was received, the
/// settings and decisions, every result. Not yet on disk is at most what came in the last
/// `commit_interval_s`, and the write in progress. Everything but `finish` and `flush` returns immediately
/// and may be called from any thread.
class Recorder : public FrameListener {
 public:
  /// Creates the file, or goes on in one that a recorder wrote: then its times and frame indices follow
  /// those that are in the file.
  static Result<std::shared_ptr<Recorder>> open(const std::string& path, const RecordingFacts& facts,
                                                const RecorderOptions& options = {});

  /// Listener of a StreamReceiver: a raw pose of any performer.
  virtual void pose_received(const ReceivedPose& pose) = 0;

  /// From here on the frames belong to a take of this name, until `end_take`; all are kept either way. A take
  /// that is still open ends.
  virtual void begin_take(const std::string& name) = 0;
  virtual void end_take() = 0;

  /// The markers of this session, in place of those before.
  virtual void set_markers(const Markers& markers) = 0;
  /// The project into the same file, beside what is recorded, in place of the one there; with the next write.
  virtual void save_project(std::shared_ptr<const Project> project) = 0;
  /// Takes of the file, also of its runs before, by the names they have when this is written.
  virtual void edit_takes(const TakeEdits& edits) = 0;
  /// Where a library can be opened again that frames will name, other than that of RecordingFacts.
  virtual void set_library_path(const std::shared_ptr<const MotionLibrary>& library,
                                const std::string& path) = 0;

  struct State {
    std::string path;
    std::uint64_t frames = 0, poses = 0, bytes = 0;
    double behind_s = 0;     ///< age of the oldest frame that is not on disk yet
    std::string take;        ///< being recorded; empty = none
    std::string failure;     ///< why nothing more is written (disk full), or would not be found (the file was
                             ///< deleted): frames are lost from then on. Empty again when it could go on
    std::uint64_t lost = 0;  ///< frames and poses that are not and will not be on disk
  };
  virtual State state() const = 0;

  /// What is already written, readable while it goes on, with this session's times and indices: for a
  /// history that reaches back to the disk.
  virtual std::shared_ptr<const FrameStore> store() const = 0;

  /// Waits until all that was handed over is on disk. @return why it is not
  virtual Status flush() = 0;
  /// Waits until all is on disk, with the fingerprint of the library, and closes the file. @return what went
  /// wrong
  virtual Status finish() = 0;
};

}  // namespace abrazo
