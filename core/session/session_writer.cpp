#include "core/session/session_writer.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <utility>

#include "core/base/json_text.hpp"
#include "core/base/output_file.hpp"
#include "core/base/utc_time.hpp"
#include "core/base/version.hpp"
#include "core/session/decisions_json.hpp"
#include "core/session/frame_row.hpp"
#include "core/session/library_reference.hpp"
#include "core/session/project_rows.hpp"
#include "core/session/project_schema.hpp"
#include "core/session/session_schema.hpp"

namespace abrazo {

namespace fs = std::filesystem;

namespace {

/// A frame with its state is some 9 kB, one without 3.5 kB: four rows to a page, and few that need a second.
constexpr int page_bytes = 16384;
/// The log is moved into the file when it has so many bytes: some 40 s.
constexpr std::int64_t bytes_in_log = 16 << 20;
/// Between two sessions in one file.
constexpr double pause_s = 1;

std::string json_list(const std::vector<std::string>& names) {
  JsonText json;
  json.begin_array();
  for (const std::string& name : names) json.value(name);
  return json.end_array().take();
}

/// The path from the session file's folder; empty when there is none (another drive).
std::string path_from(const std::string& session, const std::string& library) {
  std::error_code failure;
  const fs::path folder = fs::absolute(session, failure).parent_path();
  const fs::path relative = fs::relative(fs::absolute(library, failure), folder, failure);
  return failure ? std::string() : relative.generic_string();
}

}  // namespace

struct SessionWriter::Statements {
  SessionStatement frame, pose, pair, settings, decisions, begin, commit;
};

SessionWriter::SessionWriter(SessionDatabase database, RecordingFacts facts)
    : facts_(std::move(facts)), database_(std::move(database)), file_(database_.path()) {
  memory_.input = facts_.input;
}

SessionWriter::~SessionWriter() = default;

Result<std::unique_ptr<SessionWriter>> SessionWriter::open(const std::string& path,
                                                           const RecordingFacts& facts,
                                                           const RecorderOptions& options) {
  std::error_code failure;
  if (fs::is_directory(path, failure)) return Error{"this is a folder; name a file in it", path};
  auto database = SessionDatabase::open(path, SessionDatabase::Access::Create);
  if (!database) return database.error();
  std::unique_ptr<SessionWriter> writer(new SessionWriter(std::move(*database), facts));
  const Status prepared = writer->prepare_file(options);
  if (!prepared) return prepared.error();
  return writer;
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
  // From here to the end there is always a transaction of this writer: nobody else can write in between.
  if (const Status begun = database_.execute("BEGIN IMMEDIATE"); !begun) return begun;
  const Status current = *empty ? create_session_schema(database_) : migrate_session_schema(database_);
  if (!current) return current;
  if (const Status begun = begin_run(); !begun) return begun;
  if (const Status prepared = prepare_statements(); !prepared) return prepared;
  // In the file itself, so that it is a session file whatever becomes of the log.
  if (Status done = keep_fault(statements_->commit); !done) return done;
  (void)database_.execute("PRAGMA wal_checkpoint(PASSIVE)");
  committed_ = memory_;
  return keep_fault(statements_->begin);
}

/// A file that is gone on in keeps its frames; those of this session come after them.
Status SessionWriter::begin_run() {
  if (const Status closed = close_open_takes(); !closed) return closed;
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
  auto run =
      database_.prepare("INSERT INTO runs (begun_at, program, offset_s, offset_frames) VALUES (?, ?, ?, ?)");
  if (!run) return run.error();
  run->bind(0, utc_now()).bind(1, std::string("abrazo ") + version());
  run->bind(2, origin_.offset_s).bind(3, origin_.offset_frames);
  if (const Status done = run->run(); !done) return done;
  run_ = database_.last_row_id();
  const auto known = database_.integer("SELECT count(*) FROM meta");
  if (!known) return known.error();
  if (known->value_or(0) > 0) return Done{};
  return database_.execute(
      "INSERT INTO meta VALUES ('units', 'm, s; right-handed, Y up'), ('poses', 'float64 [25][3], "
      "little-endian')");
}

/// Of a session that was cut off: they end with its last frame.
Status SessionWriter::close_open_takes() {
  return database_.execute(
      "UPDATE takes SET last_frame = (SELECT max(frame) FROM frames), "
      "end_s = (SELECT time_s FROM frames ORDER BY frame DESC LIMIT 1) WHERE end_s IS NULL");
}

Status SessionWriter::prepare_statements() {
  auto frame = database_.prepare(frame_insert());
  auto pose = database_.prepare(
      "INSERT INTO poses (performer, arrived_s, assembled_s, time_s, sender_time_s, counter, discontinuous, "
      "pose, "
      "checksum) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
  auto pair = database_.prepare("INSERT OR IGNORE INTO pairs VALUES (?, ?, ?, ?, ?, ?)");
  auto settings = database_.prepare("INSERT INTO settings VALUES (?, ?, ?)");
  auto decisions = database_.prepare("INSERT INTO decisions VALUES (?, ?, ?)");
  auto begin = database_.prepare("BEGIN IMMEDIATE");
  auto commit = database_.prepare("COMMIT");
  for (const auto* statement : {&frame, &pose, &pair, &settings, &decisions, &begin, &commit})
    if (!*statement) return statement->error();
  statements_ = std::make_unique<Statements>(Statements{std::move(*frame), std::move(*pose), std::move(*pair),
                                                        std::move(*settings), std::move(*decisions),
                                                        std::move(*begin), std::move(*commit)});
  return Done{};
}

Status SessionWriter::write(const FrameSnapshot& frame) {
  const auto index = static_cast<std::int64_t>(frame.index + origin_.offset_frames);
  FrameRow row = row_of(frame, static_cast<std::uint64_t>(index), origin_.offset_s);
  if (const Status noted = note_input(index); !noted) return noted;
  if (const Status noted = note_library(frame, index); !noted) return noted;
  if (const Status noted = note_pairs(frame); !noted) return noted;
  if (const Status noted = note_settings(frame, index, row.time_s); !noted) return noted;
  if (const Status noted = note_take(index, row.time_s); !noted) return noted;
  row.input = memory_.input_id;
  row.library = memory_.library_id;
  bind_row(statements_->frame, row);
  if (Status written = keep_fault(statements_->frame); !written) return written;
  if (!memory_.has_first_frame) {
    auto run = database_.prepare("UPDATE runs SET first_frame = ? WHERE id = ?");
    if (!run) return keep_fault(run.error());
    if (Status noted = keep_fault(run->bind(0, index).bind(1, run_)); !noted) return noted;
    memory_.has_first_frame = true;
  }
  memory_.last_frame = index;
  memory_.last_s = row.time_s;
  return Done{};
}

Status SessionWriter::note_input(std::int64_t frame) {
  if (memory_.input_id || memory_.input.empty()) return Done{};
  auto input = database_.prepare("INSERT INTO inputs (input, first_frame) VALUES (?, ?)");
  if (!input) return keep_fault(input.error());
  if (Status written = keep_fault(input->bind(0, memory_.input).bind(1, frame)); !written) return written;
  memory_.input_id = database_.last_row_id();
  return Done{};
}

Status SessionWriter::note_library(const FrameSnapshot& frame, std::int64_t index) {
  const Library library = frame.library ? frame.library : facts_.library;
  if (memory_.library_id && (!library || library == memory_.library)) return Done{};
  const bool is_first = !library || !memory_.library_id;
  const auto named = library_paths_.find(library);
  const std::string path = library && named != library_paths_.end() ? named->second
                           : is_first                               ? facts_.library_path
                                                                    : std::string();
  auto row = database_.prepare(
      "INSERT INTO libraries (relative_path, absolute_path, name, pairs, fingerprint, excluded_takes, "
      "first_frame) "
      "VALUES (?, ?, ?, ?, ?, ?, ?)");
  if (!row) return keep_fault(row.error());
  std::error_code failure;
  if (path.empty())
    row->bind_null(0).bind_null(1);
  else
    row->bind(0, path_from(database_.path(), path))
        .bind(1, fs::absolute(path, failure).lexically_normal().string());
  row->bind(2, library ? library->name() : facts_.library_name);
  row->bind(3, library ? static_cast<std::uint64_t>(library->pair_count()) : facts_.library_pairs);
  if (library)
    row->bind(4, library_fingerprint(*library));
  else
    row->bind_null(4);
  row->bind(5, json_list(facts_.excluded_takes)).bind(6, index);
  if (Status written = keep_fault(*row); !written) return written;
  memory_.library_id = database_.last_row_id();
  memory_.library = library;
  memory_.pairs.assign(library ? static_cast<std::size_t>(library->pair_count()) : 0, false);
  return Done{};
}

/// Every pair that was a candidate has a row that says which recorded frame it is.
Status SessionWriter::note_pairs(const FrameSnapshot& frame) {
  for (const Candidate& candidate : frame.result.candidates) {
    const auto pair = static_cast<std::size_t>(candidate.pair);
    if (candidate.pair < 0 || pair >= memory_.pairs.size() || memory_.pairs[pair]) continue;
    const MotionLibrary& library = *memory_.library;
    const PairSource& source = library.source(candidate.pair);
    SessionStatement& row = statements_->pair;
    row.bind(0, *memory_.library_id).bind(1, candidate.pair);
    row.bind(2, library.take_of(candidate.pair).name).bind(3, static_cast<std::int64_t>(source.frame));
    row.bind(4, source.swapped);
    if (const std::string_view label = library.label(candidate.pair); label.empty())
      row.bind_null(5);
    else
      row.bind(5, label);
    if (Status written = keep_fault(row); !written) return written;
    memory_.pairs[pair] = true;
  }
  return Done{};
}

Status SessionWriter::note_settings(const FrameSnapshot& frame, std::int64_t index, double time_s) {
  if (memory_.settings != frame.settings) {
    SessionStatement& row = statements_->settings;
    row.bind(0, index).bind(1, time_s).bind(2, settings_json(frame.settings));
    if (Status written = keep_fault(row); !written) return written;
    memory_.settings = frame.settings;
  }
  if (memory_.decisions && memory_.decided == frame.decisions) return Done{};
  const Decisions decisions = frame.decisions ? *frame.decisions : Decisions{};
  if (memory_.decisions != decisions) {
    SessionStatement& row = statements_->decisions;
    row.bind(0, index).bind(1, time_s).bind(2, decisions_json(decisions));
    if (Status written = keep_fault(row); !written) return written;
    memory_.decisions = decisions;
  }
  memory_.decided = frame.decisions;
  return Done{};
}

Status SessionWriter::note_take(std::int64_t index, double time_s) {
  if (!memory_.wanted_take) return Done{};
  auto take =
      database_.prepare("INSERT INTO takes (name, begun_at, start_s, first_frame) VALUES (?, ?, ?, ?)");
  if (!take) return keep_fault(take.error());
  take->bind(0, *memory_.wanted_take).bind(1, memory_.wanted_take_begun_at).bind(2, time_s).bind(3, index);
  if (Status written = keep_fault(*take); !written) return written;
  memory_.take_id = database_.last_row_id();
  memory_.wanted_take.reset();
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

Result<std::int64_t> SessionWriter::performer_id(const std::string& name) {
  if (const auto known = memory_.performers.find(name); known != memory_.performers.end())
    return known->second;
  auto found = database_.prepare("SELECT id FROM performers WHERE name = ?");
  if (!found) return keep_fault(found.error()).error();
  const auto row = found->bind(0, name).step();
  if (!row) {
    fault_ = found->fault();
    return row.error();
  }
  std::int64_t id = *row ? found->integer(0) : 0;
  found->reset();
  if (!*row) {
    auto added = database_.prepare("INSERT INTO performers (name) VALUES (?)");
    if (!added) return keep_fault(added.error()).error();
    if (const Status written = keep_fault(added->bind(0, name)); !written) return written.error();
    id = database_.last_row_id();
  }
  return memory_.performers[name] = id;
}

Status SessionWriter::write(const ReceivedPose& received) {
  const auto performer = performer_id(received.performer);
  if (!performer) return performer.error();
  SessionStatement& row = statements_->pose;
  const auto shifted = [&](int at, double session_s) {
    if (session_s < 0)
      row.bind_null(at);
    else
      row.bind(at, session_s + origin_.offset_s);
  };
  const auto bytes = pose_bytes(received.pose.pose);
  Checksum sum;
  sum.add(std::span<const std::uint8_t>(bytes));
  row.bind(0, *performer);
  shifted(1, received.pose.arrived_s);
  shifted(2, received.pose.assembled_s);
  row.bind(3, received.pose.time_s);
  if (received.sender_time_s)
    row.bind(4, *received.sender_time_s);
  else
    row.bind_null(4);
  row.bind(5, received.pose.frame).bind(6, received.pose.discontinuous);
  row.bind(7, std::span<const std::uint8_t>(bytes)).bind(8, sum.value());
  return keep_fault(row);
}

/// A session that has the times of its file has the markers of all its runs, too.
Status SessionWriter::write(const Markers& markers) {
  auto cleared =
      database_.prepare(facts_.has_times_of_file ? "DELETE FROM markers WHERE run <= ?1 OR run IS NULL"
                                                 : "DELETE FROM markers WHERE run = ?1");
  if (!cleared) return keep_fault(cleared.error());
  if (Status done = keep_fault(cleared->bind(0, run_)); !done) return done;
  auto row = database_.prepare("INSERT INTO markers (id, run, time_s, name) VALUES (?, ?, ?, ?)");
  if (!row) return keep_fault(row.error());
  for (const Marker& marker : markers.all()) {
    // Of a session of its own in the file the numbers may be taken.
    facts_.has_times_of_file ? row->bind(0, marker.id) : row->bind_null(0);
    row->bind(1, run_).bind(2, marker.time_s + origin_.offset_s).bind(3, marker.name);
    if (Status written = keep_fault(*row); !written) return written;
  }
  return Done{};
}

Status SessionWriter::write(const Project& project) {
  return keep_fault(write_project(database_, project));
}

Status SessionWriter::edit_takes(const TakeEdits& edits) {
  return keep_fault(apply_take_edits(database_, edits));
}

void SessionWriter::set_input(const std::string& input) {
  if (input == memory_.input) return;
  memory_.input = input;
  memory_.input_id.reset();
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
  // What was written is on disk; that somebody else writes now is the next batch's trouble.
  is_open_ = statements_->begin.run().ok();
  return Done{};
}

Status SessionWriter::begin_batch() {
  if (is_open_) return Done{};
  const Status begun = keep_fault(statements_->begin);
  is_open_ = begun.ok();
  return begun;
}

void SessionWriter::roll_back() {
  memory_ = committed_;
  (void)database_.execute("ROLLBACK");  // fails when SQLite has already done it
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

std::string SessionWriter::misplaced() const {
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
  return {};
}

/// A file without a name is gone once it is closed.
Status SessionWriter::write_again() {
  std::error_code failure;
  const std::string& path = database_.path();
  const bool is_free = !fs::exists(path, failure);
  const std::string again = is_free ? path : with_suffix(path, "-deleted-" + utc_now());
  if (Status copied = database_.copy_to(again); !copied)
    return Error{
        "the file was deleted while it was recorded, and cannot be written again: " + copied.error().message,
        path};
  if (is_free) return Done{};
  return Error{
      "the file was deleted while it was recorded, and another took its name; the recording is in '" + again +
          "'",
      path};
}

Status SessionWriter::close(std::uint64_t lost) {
  Status ended = begin_batch();
  if (ended) ended = end_take();
  auto run = database_.prepare("UPDATE runs SET ended_at = ?, lost = ? WHERE id = ?");
  if (ended && run) ended = keep_fault(run->bind(0, utc_now()).bind(1, lost).bind(2, run_));
  if (ended) ended = keep_fault(statements_->commit);
  if (!ended) (void)database_.execute("ROLLBACK");
  statements_.reset();
  run = Error{};
  const WatchedFile::State place = file_.state();
  const bool is_deleted = place == WatchedFile::State::Deleted;
  if (is_deleted) {
    // Its log would be taken for that of the file that is written now.
    std::error_code ignored;
    for (const char* end : {"-wal", "-shm"}) fs::remove(database_.path() + end, ignored);
  }
  const Status again = is_deleted ? write_again() : Status(Done{});
  const Status closed = is_deleted ? database_.abandon() : database_.close();
  if (!ended) return ended;
  if (!again) return again;
  if (closed && place == WatchedFile::State::Moved)
    return Error{
        "the file was moved or renamed while it was recorded; the recording is whole, under its new name",
        database_.path()};
  return closed;
}

}  // namespace abrazo
