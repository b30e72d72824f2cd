#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/watched_file.hpp"
#include "core/session/file/recorded_frames.hpp"
#include "core/session/file/recording_facts.hpp"
#include "core/session/file/session_database.hpp"
#include "core/session/file/session_edit.hpp"
#include "core/session/frames/decisions.hpp"
#include "core/session/frames/markers.hpp"
#include "core/stream/receive/stream_receiver.hpp"

namespace abrazo {

struct Project;

/// Writes frames, poses and takes into a session file in transactions. A failed transaction also restores the
/// state of this object, so that the same data can be written again. Used by one thread.
class SessionWriter {
 public:
  /// Where the frames come from: a recording in progress, or memory and other files. A run of the first kind
  /// without an end was cut off, and the reader reports it. A run of the second kind has its end from the
  /// start: what a stopped save did not write is still in the history.
  enum class Origin { Live, Saved };

  /// Creates the file or continues it; locks it against other writers until it is closed.
  static Result<std::unique_ptr<SessionWriter>> open(const std::string& path, const RecordingFacts& facts,
                                                     const RecorderOptions& options,
                                                     Origin frames = Origin::Live);

  /// Writes into the running transaction.
  Status write(const FrameSnapshot& frame);
  Status write(const ReceivedPose& pose);
  void begin_take(const std::string& name);
  Status end_take();
  Status write(const Markers& markers);
  /// Replaces the project in the file. Its markers are in session time.
  Status write(const Project& project);
  Status edit_takes(const TakeEdits& edits);
  void set_library_path(const std::shared_ptr<const MotionLibrary>& library, const std::string& path);

  /// The row of the library of the newest frame, and the library itself if available.
  std::optional<std::int64_t> library_row() const { return memory_.library_id; }
  const std::shared_ptr<const MotionLibrary>& library() const { return memory_.library; }
  /// Set afterwards, because it is known later than the first frame.
  Status set_fingerprint(std::int64_t library_row, const std::string& fingerprint);

  /// Must be called before the first `write` after a commit. An Error if another program writes to the file
  Status begin_batch();
  /// Ends the transaction; its data survives a power failure. Begins the next if possible.
  Status commit(std::uint64_t lost);
  /// Discards everything written since the last commit.
  void roll_back();

  DatabaseFault fault() const { return fault_; }  ///< of the last function that failed
  /// Mapping of the session's times and indices to those of the file.
  const RecordedFrames::Origin& origin() const { return origin_; }
  std::uint64_t bytes() const;  ///< of the file with its log, which has pages of the file again
  /// Of the file once its log is in it; 0 if that cannot be read.
  std::uint64_t file_bytes();
  /// Why written data will not be found under the file's name (deleted, moved, truncated or overwritten by
  /// another program); empty if all is well.
  std::string misplaced();

  /// Commits and merges the log into the file. A file that was deleted meanwhile is written again in full; if
  /// that must be under another name, the Error says where.
  Status close(std::uint64_t lost);

 private:
  using Library = std::shared_ptr<const MotionLibrary>;
  /// State that depends on the rows already written.
  struct Memory {
    std::optional<Settings> settings;
    std::optional<bool> is_learning;
    std::optional<Decisions> decisions;
    std::shared_ptr<const Decisions> decided;  ///< the value from which `decisions` was made
    std::string input;
    std::optional<std::int64_t> input_id;
    Library library;
    std::optional<std::int64_t> library_id;
    std::vector<bool> pairs;  ///< by pair of the library: whether it has a row
    std::map<std::string, std::int64_t> performers;
    std::optional<std::string> wanted_take;  ///< take to begin with the next frame
    std::string wanted_take_begun_at;
    std::optional<std::int64_t> take_id;  ///< open take
    bool has_first_frame = false;
    std::int64_t last_frame = -1;
    double last_s = 0;
  };
  struct Statements;

  SessionWriter(SessionDatabase database, RecordingFacts facts, Origin frames);
  Status prepare_file(const RecorderOptions& options);
  Status begin_run();
  Status prepare_statements();
  Status note_input(const FrameSnapshot& frame, std::int64_t index);
  Status note_library(const FrameSnapshot& frame, std::int64_t index);
  Status note_pairs(const FrameSnapshot& frame);
  Status note_settings(const FrameSnapshot& frame, std::int64_t index, double time_s);
  Status note_take(std::int64_t index, double time_s);
  Result<std::int64_t> performer_id(const std::string& name);
  void look_for_other_writers();
  void note_own_write();
  bool has_own_log() const;
  void remove_own_log();
  Status write_again();
  Status close_database(WatchedFile::State place);
  Status keep_fault(SessionStatement& statement);
  Status keep_fault(Status status);

  RecordingFacts facts_;
  Origin frames_;
  std::map<Library, std::string> library_paths_;
  RecordedFrames::Origin origin_;
  std::int64_t run_ = 0;
  DatabaseFault fault_ = DatabaseFault::Other;
  Memory memory_, committed_;
  bool is_open_ = true;  ///< a transaction is open
  SessionDatabase database_;
  WatchedFile file_;
  std::int64_t most_on_disk_ = 0;               ///< largest file size seen: a shorter file was truncated
  bool was_cut_ = false;                        ///< or written over
  std::optional<WatchedFile> log_, log_index_;  ///< created or found by this connection
  /// Times of the last write to the file and to its log, which were this writer's.
  std::optional<std::int64_t> file_written_ns_, log_written_ns_;
  std::unique_ptr<Statements> statements_;  // after the database: destroyed before it

 public:
  ~SessionWriter();
};

}  // namespace abrazo
