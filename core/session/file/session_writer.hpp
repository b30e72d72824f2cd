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

/// Puts frames, poses and takes into a session file, one transaction after the other. What a transaction that
/// failed had changed here is taken back too, so that the same can be written again. Used by one thread.
class SessionWriter {
 public:
  /// Creates the file or goes on in it; holds the file against other writers until it is closed.
  static Result<std::unique_ptr<SessionWriter>> open(const std::string& path, const RecordingFacts& facts,
                                                     const RecorderOptions& options);

  /// Into the running transaction.
  Status write(const FrameSnapshot& frame);
  Status write(const ReceivedPose& pose);
  void begin_take(const std::string& name);
  Status end_take();
  Status write(const Markers& markers);
  /// In place of the project that the file has. Its markers are in the session's time.
  Status write(const Project& project);
  Status edit_takes(const TakeEdits& edits);
  void set_library_path(const std::shared_ptr<const MotionLibrary>& library, const std::string& path);

  /// The row of the library that the newest frame was solved with, and the library where it is at hand.
  std::optional<std::int64_t> library_row() const { return memory_.library_id; }
  const std::shared_ptr<const MotionLibrary>& library() const { return memory_.library; }
  /// Rows are written without it: it is known later than the first frame.
  Status set_fingerprint(std::int64_t library_row, const std::string& fingerprint);

  /// To be called before the first `write` after a commit. @return why nothing can be written now: another
  /// program writes in the file
  Status begin_batch();
  /// Ends the transaction: on disk, also when the power fails. Begins the next where it can.
  Status commit(std::uint64_t lost);
  /// Forgets what was written since the last commit.
  void roll_back();

  DatabaseFault fault() const { return fault_; }  ///< of the last function that failed
  /// How the session's times and indices become those of the file.
  const RecordedFrames::Origin& origin() const { return origin_; }
  std::uint64_t bytes() const;  ///< of the file with its log
  /// Why what is written will not be found under the file's name: it was deleted or moved, or another program
  /// cut it short or wrote over its beginning. Or empty.
  std::string misplaced();

  /// Commits and makes it one file. One that was deleted meanwhile is written again, whole; the Error says
  /// where when that could not be its own name.
  Status close(std::uint64_t lost);

 private:
  using Library = std::shared_ptr<const MotionLibrary>;
  /// What is known of the rows that are there already.
  struct Memory {
    std::optional<Settings> settings;
    std::optional<Decisions> decisions;
    std::shared_ptr<const Decisions> decided;  ///< the value `decisions` was taken from
    std::string input;
    std::optional<std::int64_t> input_id;
    Library library;
    std::optional<std::int64_t> library_id;
    std::vector<bool> pairs;  ///< of the library, that have a row
    std::map<std::string, std::int64_t> performers;
    std::optional<std::string> wanted_take;  ///< begins with the next frame
    std::string wanted_take_begun_at;
    std::optional<std::int64_t> take_id;  ///< that is open
    bool has_first_frame = false;
    std::int64_t last_frame = -1;
    double last_s = 0;
  };
  struct Statements;

  SessionWriter(SessionDatabase database, RecordingFacts facts);
  Status prepare_file(const RecorderOptions& options);
  Status begin_run();
  Status close_open_takes();
  Status prepare_statements();
  Status note_input(const FrameSnapshot& frame, std::int64_t index);
  Status note_library(const FrameSnapshot& frame, std::int64_t index);
  Status note_pairs(const FrameSnapshot& frame);
  Status note_settings(const FrameSnapshot& frame, std::int64_t index, double time_s);
  Status note_take(std::int64_t index, double time_s);
  Result<std::int64_t> performer_id(const std::string& name);
  bool has_own_log() const;
  void remove_own_log();
  Status write_again();
  Status close_database(WatchedFile::State place);
  Status keep_fault(SessionStatement& statement);
  Status keep_fault(Status status);

  RecordingFacts facts_;
  std::map<Library, std::string> library_paths_;
  RecordedFrames::Origin origin_;
  std::int64_t run_ = 0;
  DatabaseFault fault_ = DatabaseFault::Other;
  Memory memory_, committed_;
  bool is_open_ = true;  ///< a transaction
  SessionDatabase database_;
  WatchedFile file_;
  std::int64_t most_on_disk_ = 0;  ///< bytes of the file that were there: it never becomes shorter
  bool was_cut_ = false;
  std::optional<WatchedFile> log_, log_index_;  ///< those that this connection made or found
  std::unique_ptr<Statements> statements_;      // after the database: gone before it

 public:
  ~SessionWriter();
};

}  // namespace abrazo
