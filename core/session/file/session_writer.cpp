#include "core/session/file/session_writer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>

#include "core/base/atomic_file.hpp"
#include "core/base/output_file.hpp"
#include "core/base/utc_time.hpp"
#include "core/base/version.hpp"
#include "core/session/file/frame_row.hpp"
#include "core/session/file/project_rows.hpp"
#include "core/session/file/session_schema.hpp"
#include "core/session/file/session_writer_statements.hpp"

namespace abrazo {

namespace fs = std::filesystem;

namespace {

/// A frame is some 4 kB: four rows to a page. Every 32nd has its state, 25 kB, and needs further pages.
constexpr int page_bytes = 16384;
/// Size at which the log is moved into the file: about 40 s.
constexpr std::int64_t bytes_in_log = 16 << 20;
/// Between two sessions in one file.
constexpr double pause_s = 1;

}  // namespace

SessionWriter::SessionWriter(SessionDatabase database, RecordingFacts facts, Origin frames)
    : facts_(std::move(facts)), frames_(frames), database_(std::move(database)), file_(database_.path()) {
  memory_.input = facts_.input;
}

SessionWriter::~SessionWriter() = default;

Result<std::unique_ptr<SessionWriter>> SessionWriter::open(const std::string& path,
                                                           const RecordingFacts& facts,
                                                           const RecorderOptions& options, Origin frames) {
  std::error_code failure;
  if (fs::is_directory(path, failure)) return Error{"this is a folder; name a file in it", path};
  // Before anything is changed: a file that has become one with a log could not be read there any more.
  if (const auto able = abilities_of_folder_with(path); able && !(able->locks && able->shares_memory))
    return Error{std::string("cannot be recorded on this disk, which ") +
                     (able->locks ? "shares no memory of files" : "locks no files") +
                     " (is it a network drive?); record to a local one, and copy the session afterwards",
                 path};
  const bool is_new = !fs::exists(fs::symlink_status(path, failure));
  auto database = SessionDatabase::open(path, SessionDatabase::Access::Create);
  if (!database) return database.error();
  std::unique_ptr<SessionWriter> writer(new SessionWriter(std::move(*database), facts, frames));
  const Status prepared = writer->prepare_file(options);
  if (prepared) return writer;
  if (is_new && writer->database_.fault() != DatabaseFault::Busy) {  // or somebody else has just made it
    writer.reset();
    for (const char* ending : {"", "-journal", "-wal", "-shm"}) fs::remove(path + ending, failure);
  }
  return prepared.error();
}

Status SessionWriter::keep_fault(SessionStatement& statement) {
  Status done = statement.run();
  if (!done) fault_ = statement.fault();
  return done;
}

Status SessionWriter::keep_fault(Status status) {
  if (!status) fault_ = database_.fault();
  return status;
}

Status SessionWriter::prepare_file(const RecorderOptions& options) {
  database_.set_patience(500);
  const auto empty = is_empty_database(database_);
  if (!empty) return empty.error();
  if (!*empty) {
    const Status ours = check_session_schema(database_);
    if (!ours) return ours;
  } else if (const Status sized = database_.execute("PRAGMA page_size=" + std::to_string(page_bytes));
             !sized) {
    return sized;
  }
  const auto mode = database_.text("PRAGMA journal_mode=WAL");
  if (!mode) return mode.error();
  if (mode->value_or("") != "wal")
    return Error{"the disk cannot keep a log beside the file (is it a network drive?); record to a local one",
                 database_.path()};
  // A file that began as a project has smaller pages.
  const auto page = database_.integer("PRAGMA page_size");
  if (!page) return page.error();
  const std::int64_t size = std::max<std::int64_t>(512, page->value_or(page_bytes));
  // FULL: every commit is on the platter before the next, so that also a power cut costs no more than the
  // last fraction of a second. The wait is this thread's alone.
  const Status tuned = database_.execute(
      "PRAGMA synchronous=FULL; PRAGMA wal_autocheckpoint=" + std::to_string(bytes_in_log / size) +
      "; PRAGMA journal_size_limit=67108864; PRAGMA temp_store=MEMORY");
  if (!tuned) return tuned;
  if (options.largest_file_bytes > 0) {
    const auto limited =
        database_.integer("PRAGMA max_page_count=" +
                          std::to_string(static_cast<std::int64_t>(options.largest_file_bytes) / size));
    if (!limited) return limited.error();
  }
  // From here on this writer always holds a transaction, so no other program can write.
  if (const Status begun = database_.execute("BEGIN IMMEDIATE"); !begun) return begun;
  if (*empty)
    if (const Status created = create_session_schema(database_); !created) return created;
  if (const Status begun = begin_run(); !begun) return begun;
  if (const Status prepared = prepare_statements(); !prepared) return prepared;
  // In the file itself, so that it is a session file even if the log is lost.
  if (Status done = keep_fault(statements_->commit); !done) return done;
  (void)database_.execute("PRAGMA wal_checkpoint(PASSIVE)");
  committed_ = memory_;
  log_.emplace(database_.path() + "-wal");
  log_index_.emplace(database_.path() + "-shm");
  note_own_write();
  return keep_fault(statements_->begin);
}

/// A file that is gone on in keeps its frames; those of this session come after them.
Status SessionWriter::begin_run() {
  if (const Status closed = end_open_takes(database_); !closed) return closed;
  auto last = database_.prepare("SELECT frame, time_s FROM frames ORDER BY frame DESC LIMIT 1");
  if (!last) return last.error();
  const auto has_last = last->step();
  if (!has_last) return has_last.error();
  if (*has_last) {
    origin_.first_frame = static_cast<std::uint64_t>(last->integer(0) + 1);
    if (!facts_.has_times_of_file) {
      origin_.offset_frames = origin_.first_frame;
      origin_.offset_s = std::ceil(last->real(1)) + pause_s;
    }
  }
  last->reset();
  auto run = database_.prepare(
      "INSERT INTO runs (begun_at, program, offset_s, offset_frames, ended_at) VALUES (?, ?, ?, ?, ?)");
  if (!run) return run.error();
  run->bind(0, utc_now()).bind(1, std::string("abrazo ") + version());
  run->bind(2, origin_.offset_s).bind(3, origin_.offset_frames);
  if (frames_ == Origin::Saved)
    run->bind(4, utc_now());
  else
    run->bind_null(4);
  if (const Status done = run->run(); !done) return done;
  run_ = database_.last_row_id();
  const auto known = database_.integer("SELECT count(*) FROM meta");
  if (!known) return known.error();
  if (known->value_or(0) > 0) return Done{};
  return database_.execute(
      "INSERT INTO meta VALUES ('units', 'm, s; right-handed, Y up'), ('poses', 'float64 [25][3], "
      "little-endian')");
}

Status SessionWriter::prepare_statements() {
  auto frame = database_.prepare(frame_insert());
  auto pose = database_.prepare(
      "INSERT INTO poses (performer, arrived_s, assembled_s, time_s, sender_time_s, counter, discontinuous, "
      "pose, "
      "checksum) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
  auto pair = database_.prepare("INSERT OR IGNORE INTO pairs VALUES (?, ?, ?, ?, ?, ?)");
  auto settings = database_.prepare("INSERT INTO settings VALUES (?, ?, ?)");
  auto learning = database_.prepare("INSERT INTO learning VALUES (?, ?)");
  auto decisions = database_.prepare("INSERT INTO decisions VALUES (?, ?, ?)");
  auto begin = database_.prepare("BEGIN IMMEDIATE");
  auto commit = database_.prepare("COMMIT");
  for (const auto* statement : {&frame, &pose, &pair, &settings, &learning, &decisions, &begin, &commit})
    if (!*statement) return statement->error();
  statements_ = std::make_unique<Statements>(
      Statements{std::move(*frame), std::move(*pose), std::move(*pair), std::move(*settings),
                 std::move(*learning), std::move(*decisions), std::move(*begin), std::move(*commit)});
  return Done{};
}

void SessionWriter::begin_take(const std::string& name) {
  memory_.wanted_take = name;
  memory_.wanted_take_begun_at = utc_now();
}

Status SessionWriter::end_take() {
  memory_.wanted_take.reset();
  if (!memory_.take_id) return Done{};
  auto take = database_.prepare("UPDATE takes SET end_s = ?, last_frame = ? WHERE id = ?");
  if (!take) return keep_fault(take.error());
  take->bind(0, memory_.last_s).bind(1, memory_.last_frame).bind(2, *memory_.take_id);
  if (Status written = keep_fault(*take); !written) return written;
  memory_.take_id.reset();
  return Done{};
}

Status SessionWriter::write(const Project& project) {
  return keep_fault(write_project(database_, project));
}

Status SessionWriter::edit_takes(const TakeEdits& edits) {
  return keep_fault(apply_take_edits(database_, edits));
}

Status SessionWriter::set_fingerprint(std::int64_t library_row, const std::string& fingerprint) {
  auto library = database_.prepare("UPDATE libraries SET fingerprint = ? WHERE id = ?");
  if (!library) return keep_fault(library.error());
  return keep_fault(library->bind(0, fingerprint).bind(1, library_row));
}

void SessionWriter::set_library_path(const Library& library, const std::string& path) {
  library_paths_[library] = path;
}

Status SessionWriter::commit(std::uint64_t lost) {
  if (lost > 0) {
    auto run = database_.prepare("UPDATE runs SET lost = ? WHERE id = ?");
    if (!run) return keep_fault(run.error());
    if (Status noted = keep_fault(run->bind(0, lost).bind(1, run_)); !noted) return noted;
  }
  if (Status done = keep_fault(statements_->commit); !done) return done;
  committed_ = memory_;
  note_own_write();
  // What was written is on disk; that another program writes now is the next batch's trouble.
  is_open_ = statements_->begin.run().ok();
  return Done{};
}

Status SessionWriter::begin_batch() {
  look_for_other_writers();
  if (is_open_) return Done{};
  const Status begun = keep_fault(statements_->begin);
  is_open_ = begun.ok();
  return begun;
}

void SessionWriter::roll_back() {
  memory_ = committed_;
  (void)database_.execute("ROLLBACK");  // fails when SQLite has already done it
  note_own_write();
  is_open_ = statements_->begin.run().ok();
}

std::uint64_t SessionWriter::bytes() const {
  std::uint64_t total = 0;
  for (const char* end : {"", "-wal"}) {
    std::error_code failure;
    const auto size = fs::file_size(database_.path() + end, failure);
    if (!failure) total += size;
  }
  return total;
}

std::uint64_t SessionWriter::file_bytes() {
  const auto pages = database_.integer("PRAGMA page_count"), size = database_.integer("PRAGMA page_size");
  if (!pages || !size) return 0;
  return static_cast<std::uint64_t>(pages->value_or(0) * size->value_or(0));
}

// This connection holds the right to write from the first row to the last, and readers write neither file: a
// time that is not of its own last write is another program's.
void SessionWriter::look_for_other_writers() {
  was_cut_ =
      was_cut_ || file_.written_ns() != file_written_ns_ || (log_ && log_->written_ns() != log_written_ns_);
}

void SessionWriter::note_own_write() {
  file_written_ns_ = file_.written_ns();
  if (log_) log_written_ns_ = log_->written_ns();
}

std::string SessionWriter::misplaced() {
  switch (file_.state()) {
    case WatchedFile::State::There:
      break;
    case WatchedFile::State::Deleted:
      return "the file was deleted while it is recorded; end the recording now, and it is written again, "
             "whole";
    case WatchedFile::State::Moved:
      return "the file was moved or renamed while it is recorded; put it back under its name, or end the "
             "recording now";
  }
  if (const auto on_disk = database_.bytes_on_disk()) {
    was_cut_ = was_cut_ || *on_disk < most_on_disk_;
    most_on_disk_ = std::max(most_on_disk_, *on_disk);
  }
  look_for_other_writers();
  if (was_cut_)
    return "the file was cut short or written over by another program while it is recorded; end the "
           "recording now, look whether it opens, and record to another file";
  return {};
}

/// What lies there may also be the log of a file that another program made under our name: live, with what
/// that has committed.
bool SessionWriter::has_own_log() const {
  return log_ && log_->state() == WatchedFile::State::There;
}

/// Log of a deleted file: it would be used as the log of the next file of this name.
void SessionWriter::remove_own_log() {
  std::error_code failure;
  const std::string& path = database_.path();
  const bool is_own = has_own_log(), is_free = !fs::exists(path, failure);
  if (is_own) fs::remove(path + "-wal", failure);
  if ((is_own || is_free) && log_index_ && log_index_->state() == WatchedFile::State::There)
    fs::remove(path + "-shm", failure);
}

/// A file without a name is gone once it is closed.
Status SessionWriter::write_again() {
  const std::string& path = database_.path();
  // First beside the name: writing takes its time, in which another program may take it.
  const std::string beside = with_suffix(path, "-deleted-" + utc_now());
  AtomicFile copy(beside);
  Status copied = database_.copy_into(copy.partial().string());
  if (copied) copied = copy.commit();
  if (!copied)
    return Error{
        "the file was deleted while it was recorded, and cannot be written again: " + copied.error().message,
        path};
  const auto is_taken = [&](const char* end) {
    std::error_code failure;
    return fs::exists(path + end, failure);
  };
  // A log without a file would be used as ours.
  const std::array<const char*, 3> ends = {"", "-wal", "-journal"};
  std::error_code failure = std::make_error_code(std::errc::file_exists);
  if (std::none_of(ends.begin(), ends.end(), is_taken)) fs::rename(beside, path, failure);
  if (!failure) return Done{};
  return Error{
      "the file was deleted while it was recorded, and another took its name; the recording is in '" +
          beside + "'",
      path};
}

/// SQLite deletes the log of a file that it closes, by its name.
Status SessionWriter::close_database(WatchedFile::State place) {
  std::error_code failure;
  const bool is_log_of_others =
      place == WatchedFile::State::Moved && !has_own_log() && fs::exists(database_.path() + "-wal", failure);
  if (!is_log_of_others) return database_.close();
  const Status moved = database_.execute("PRAGMA wal_checkpoint(TRUNCATE)");
  const Status closed = database_.abandon();
  return moved ? closed : moved;
}

Status SessionWriter::close(std::uint64_t lost) {
  Status ended = begin_batch();
  if (ended) ended = end_take();
  auto run = database_.prepare("UPDATE runs SET ended_at = max(begun_at, ?), lost = ? WHERE id = ?");
  if (ended && run) ended = keep_fault(run->bind(0, utc_now()).bind(1, lost).bind(2, run_));
  if (ended) ended = keep_fault(statements_->commit);
  if (!ended) (void)database_.execute("ROLLBACK");
  statements_.reset();
  run = Error{};
  const WatchedFile::State place = file_.state();
  const bool is_deleted = place == WatchedFile::State::Deleted;
  if (is_deleted) remove_own_log();
  const Status again = is_deleted ? write_again() : Status(Done{});
  const Status closed = is_deleted ? database_.abandon() : close_database(place);
  if (!ended) return ended;
  if (!again) return again;
  if (closed && place == WatchedFile::State::Moved)
    return Error{
        "the file was moved or renamed while it was recorded; the recording is whole, under its new name",
        database_.path()};
  if (closed && was_cut_)
    return Error{
        "the file was cut short or written over by another program while it was recorded; what was "
        "lost cannot be told, so look whether the session opens",
        database_.path()};
  return closed;
}

}  // namespace abrazo
