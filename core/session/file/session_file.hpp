#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/takes/tier.hpp"
#include "core/session/frames/decisions.hpp"
#include "core/session/frames/frame_snapshot.hpp"
#include "core/stream/receive/stream_receiver.hpp"

namespace abrazo {

class MotionLibrary;
struct ProjectReading;

/// One run of a session file: from a recorder's opening of it to its closing.
struct SessionRun {
  int id = 0;
  std::string begun_at;   ///< UTC, "2024-05-17T14:03:22Z"
  bool finished = false;  ///< closed properly; otherwise cut off, or still being recorded
  double offset_s = 0;    ///< session clock of the run + offset = time in the file
  std::uint64_t first_frame = 0, frames = 0;
  double first_s = 0, last_s = 0;
  std::uint64_t lost = 0;  ///< frames and poses that could not be written
};

/// A library with which frames of the file were solved.
struct SessionLibrary {
  int id = 0;
  std::string relative_path;  ///< to the session file's folder; empty if it was never a file
  std::string absolute_path;  ///< at the time of recording
  std::string name;
  std::uint64_t pairs = 0;
  std::string fingerprint;  ///< of its content, see library_fingerprint; empty if not available
  std::vector<std::string> excluded_takes;
  std::uint64_t first_frame = 0;  ///< solved with it
};

struct SessionTake {
  int id = 0;
  std::string name;
  double start_s = 0, end_s = 0;  ///< of its first and last frame
  std::uint64_t first_frame = 0, last_frame = 0;
  std::string begun_at;      ///< UTC
  bool interrupted = false;  ///< still being recorded, or was when the file was cut off
};

struct SessionPerformer {
  int id = 0;
  std::string name;
  std::uint64_t poses = 0;
  double first_s = 0, last_s = 0;  ///< of arrival
};

struct SessionInput {
  int id = 0;
  std::string text;  ///< URI or clip
  std::uint64_t first_frame = 0;
};

struct SessionSettings {
  std::uint64_t frame = 0;  ///< first frame solved under them
  double time_s = 0;
  Settings settings;
};

struct SessionDecisions {
  std::uint64_t frame = 0;
  double time_s = 0;
  Decisions decisions;
};

struct SessionMarker {
  int id = 0;
  double time_s = 0;
  std::string name;
};

/// The recorded frame that a solved one followed.
struct SessionSource {
  std::uint64_t frame = 0;
  double time_s = 0;
  std::string take;    ///< of the library; empty if nothing was selected, or unknown
  int take_frame = 0;  ///< 0-based
  bool swapped = false;
  std::string label;  ///< empty = none
};

/// Everything in a session file except frames and poses. Times are those of the file: seconds since its first
/// run began.
struct SessionContents {
  std::string program;  ///< the program that wrote it: "abrazo 0.4.0"
  std::vector<SessionRun> runs;
  std::vector<SessionLibrary> libraries;
  std::vector<SessionInput> inputs;
  std::vector<SessionPerformer> performers;
  std::vector<SessionTake> takes;
  std::vector<SessionSettings> settings;    ///< changes, the first at the first frame
  std::vector<SessionDecisions> decisions;  ///< the same
  std::vector<SessionMarker> markers;
  std::vector<Tier> annotations;  ///< of the session, by a person; without suggestions
  std::uint64_t frames = 0, first_frame = 0, last_frame = 0;  ///< frames: count if none is missing
  double first_s = 0, last_s = 0;                             ///< of the frames
};

/// Result of a pass over rows. Unreadable rows are skipped and counted.
struct RowsRead {
  std::uint64_t read = 0, damaged = 0;
  std::string damage;  ///< error text of the first
};

/// The content of a session, wherever it is kept: in a file, in the history of a running session, in a take
/// of a library. Thread-safe.
class SessionRecord {
 public:
  virtual ~SessionRecord() = default;

  /// The file, or another name for messages.
  virtual const std::string& where() const = 0;
  virtual const SessionContents& contents() const = 0;
  /// Visits the frames in [from_s, to_s] in order, with at least the members that need no library. Stops when
  /// `visit` fails.
  virtual Result<RowsRead> each_frame(double from_s, double to_s,
                                      const std::function<Status(const FrameSnapshot&)>& visit) const = 0;
  /// Visits received poses of a performer, in order of arrival. @param performer id; none = all
  virtual Result<RowsRead> each_pose(std::optional<int> performer, double from_s, double to_s,
                                     const std::function<Status(const ReceivedPose&)>& visit) const = 0;
  /// Visits the sources that the frames in [from_s, to_s] followed, in order. Needs no library.
  virtual Status each_source(double from_s, double to_s,
                             const std::function<Status(const SessionSource&)>& visit) const = 0;
};

/// A session file, open for reading (layout: docs/session-file.md). Readable during recording: every call
/// sees what is on disk by then, but `contents` stay those of the opening. Its frames have no mesh, no
/// selected pair and no morph steps.
class SessionFile : public SessionRecord {
 public:
  /// Recovers the log of a crash. An Error if the file is not a session file, is of a newer version, or is
  /// too damaged to have any content.
  static Result<std::shared_ptr<const SessionFile>> open(const std::string& path);

  virtual const std::string& path() const = 0;
  const std::string& where() const override { return path(); }
  /// Whether another process or recorder was writing the file at opening.
  virtual bool is_being_recorded() const = 0;
  /// Sentences about a file that was cut off or damaged; empty if it is intact.
  virtual const std::vector<std::string>& recovery() const = 0;
  /// The project kept in the file; see read_project.
  virtual Result<ProjectReading> project() const = 0;
  /// A frame by index; null if it is not kept.
  virtual Result<FrameSnapshotPtr> frame(std::uint64_t index) const = 0;
};

}  // namespace abrazo
