#include "core/session/file/session_schema.hpp"

#include <filesystem>
#include <functional>
#include <set>
#include <string_view>
#include <system_error>

#include "core/base/text.hpp"
#include "core/session/file/frame_row.hpp"
#include "core/session/file/project_schema.hpp"

namespace abrazo {

namespace {

constexpr const char* tables = R"sql(
CREATE TABLE meta (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE runs (
  id INTEGER PRIMARY KEY, begun_at TEXT NOT NULL, program TEXT NOT NULL, offset_s REAL NOT NULL,
  offset_frames INTEGER NOT NULL, first_frame INTEGER, ended_at TEXT, lost INTEGER NOT NULL DEFAULT 0);
CREATE TABLE libraries (
  id INTEGER PRIMARY KEY, relative_path TEXT, absolute_path TEXT, name TEXT, pairs INTEGER, fingerprint TEXT,
  excluded_takes TEXT NOT NULL, first_frame INTEGER NOT NULL);
CREATE TABLE pairs (
  library INTEGER REFERENCES libraries, pair INTEGER, take TEXT NOT NULL, frame INTEGER NOT NULL,
  swapped INTEGER NOT NULL, label TEXT, PRIMARY KEY (library, pair)) WITHOUT ROWID;
CREATE TABLE inputs (id INTEGER PRIMARY KEY, input TEXT NOT NULL, first_frame INTEGER NOT NULL);
CREATE TABLE performers (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE);
CREATE TABLE poses (
  id INTEGER PRIMARY KEY, performer INTEGER NOT NULL REFERENCES performers, arrived_s REAL, assembled_s REAL,
  time_s REAL, sender_time_s REAL, counter INTEGER, discontinuous INTEGER NOT NULL, pose BLOB NOT NULL,
  checksum INTEGER NOT NULL);
CREATE TABLE settings (frame INTEGER PRIMARY KEY, time_s REAL NOT NULL, json TEXT NOT NULL);
CREATE TABLE learning (frame INTEGER PRIMARY KEY, is_learning INTEGER NOT NULL);
CREATE TABLE decisions (frame INTEGER PRIMARY KEY, time_s REAL NOT NULL, json TEXT NOT NULL);
CREATE TABLE takes (
  id INTEGER PRIMARY KEY, name TEXT NOT NULL, begun_at TEXT NOT NULL, start_s REAL NOT NULL, end_s REAL,
  first_frame INTEGER NOT NULL, last_frame INTEGER);
CREATE TABLE markers (
  id INTEGER PRIMARY KEY, run INTEGER REFERENCES runs, time_s REAL NOT NULL, name TEXT NOT NULL);
)sql";

constexpr const char* views = R"sql(
CREATE INDEX frames_by_time ON frames (time_s);
CREATE INDEX poses_by_performer ON poses (performer, arrived_s);
CREATE INDEX frames_with_state ON frames (frame) WHERE state IS NOT NULL;
CREATE VIEW sources AS
  SELECT f.frame, f.time_s, p.take, p.frame AS take_frame, p.swapped, p.label, f.pair, f.source_changed,
         f.status, f.message
  FROM frames f LEFT JOIN pairs p ON p.library = f.library AND p.pair = f.pair;
CREATE VIEW measures AS
  SELECT frame, time_s, status, energy_deformation, energy_velocity, energy_constraint, bone_length_max,
         foot_lock_max_m, penetration_max_m, excess_penetration_max_m, morph_rms_m, total_us
  FROM frames;
CREATE VIEW latencies AS
  SELECT frame, time_s, 1000 * (assembled_s - arrived_s) AS assembly_ms, 1000 * (taken_s - assembled_s) AS wait_ms,
         1000 * (solved_s - taken_s) AS solve_ms, 1000 * (sent_s - solved_s) AS send_ms,
         1000 * (sent_s - arrived_s) AS total_ms
  FROM frames WHERE arrived_s IS NOT NULL;
CREATE VIEW take_list AS
  SELECT t.id, t.name, t.begun_at, t.start_s,
         coalesce(t.end_s, (SELECT max(time_s) FROM frames)) AS end_s,
         t.first_frame, coalesce(t.last_frame, (SELECT max(frame) FROM frames)) AS last_frame,
         t.end_s IS NULL AS interrupted
  FROM takes t;
)sql";

/// The tables that are made here, by their names.
std::set<std::string, std::less<>> own_tables() {
  std::set<std::string, std::less<>> names{"frames"};
  static constexpr std::string_view making = "CREATE TABLE ";
  for (const std::string_view sql : {std::string_view(tables), std::string_view(project_tables)})
    for (auto at = sql.find(making); at != std::string_view::npos; at = sql.find(making, at + 1)) {
      const auto name = sql.substr(at + making.size());
      names.emplace(name.substr(0, name.find_first_of(" (")));
    }
  return names;
}

/// What a row of the schema is that no session file has; empty for all others. Tables, views and indices
/// that were added by others are harmless.
std::string foreign_part(const SessionStatement& row) {
  static const auto own = own_tables();
  const std::string type = row.text(0), name = row.text(1), sql = lower_case(row.text(2));
  const bool is_virtual = type == "table" && trimmed(sql).starts_with("create virtual");
  if (type == "trigger") return "a trigger '" + name + "', which would run whenever the file is written";
  if (!own.contains(lower_case(name))) return {};
  if (type == "table" && !is_virtual) return {};
  return (is_virtual ? "a virtual table" : "a " + type) + " in place of its table '" + name + "'";
}

/// Tables of an untrusted file may contain triggers or views that run on access.
Status check_schema_objects(SessionDatabase& database) {
  // Reads the whole schema, so that damage in it is known as such.
  if (const auto count = database.integer("SELECT count(*) FROM sqlite_schema"); !count)
    return database.is_salvage() ? Status(Done{}) : count.error();
  auto objects = database.prepare("SELECT type, name, coalesce(sql, '') FROM sqlite_schema");
  if (!objects) return objects.error();
  while (true) {
    const auto more = objects->step();
    if (!more) return database.is_salvage() ? Status(Done{}) : more.error();
    if (!*more) return Done{};
    if (const std::string part = foreign_part(*objects); !part.empty())
      return Error{
          "the file has " + part +
              ": no program of ours made that. It was not read; ask whoever sent it for another copy",
          database.path()};
  }
}

}  // namespace

Result<bool> is_empty_database(SessionDatabase& database) {
  const auto objects = database.integer("SELECT count(*) FROM sqlite_schema");
  if (!objects) return objects.error();
  const auto id = database.integer("PRAGMA application_id");
  if (!id) return id.error();
  return objects->value_or(0) == 0 && id->value_or(0) == 0;
}

std::string log_name(const SessionDatabase& database) {
  return std::filesystem::path(log_of_session(database.path())).filename().string();
}

namespace {

/// Where nothing can be locked, nothing else is either: a file without a log beside it is whole.
bool can_be_read_without_locks(const std::string& path) {
  const auto able = abilities_of_folder_with(path);
  std::error_code failure;
  return (!able || !able->locks) && !std::filesystem::exists(log_of_session(path), failure);
}

}  // namespace

Status create_session_schema(SessionDatabase& database) {
  return database.execute("PRAGMA application_id = " + std::to_string(session_application_id) +
                          "; PRAGMA user_version = " + std::to_string(session_schema_version) + ";" + tables +
                          "CREATE TABLE frames (\n" + frame_column_definitions() + ");\n" + views +
                          project_tables);
}

Status check_session_schema(SessionDatabase& database) {
  const auto id = database.integer("PRAGMA application_id");
  if (!id) return id.error();
  if (id->value_or(0) != session_application_id) {
    const auto empty = is_empty_database(database);
    if (empty && *empty)
      return Error{database.lacks_log() ? "the file is empty, and its log '" + log_name(database) +
                                              "' is not beside it; copy that too, if this is a copy"
                                        : "the file is empty: nothing was recorded into it",
                   database.path()};
    return Error{"this is another program's SQLite database, not a session file; it was not touched",
                 database.path()};
  }
  const auto schema = database.integer("PRAGMA user_version");
  if (!schema) return schema.error();
  const std::string version = std::to_string(schema->value_or(0));
  if (schema->value_or(0) > session_schema_version)
    return Error{"the session file is of version " + version + ", this program reads version " +
                     std::to_string(session_schema_version) + "; open it with a newer Abrazo",
                 database.path()};
  if (schema->value_or(0) < 1)
    return Error{
        "the session file says that it is of version " + version + ", which there never was: it is damaged",
        database.path()};
  return check_schema_objects(database);
}

Result<SessionDatabase> open_session_database(const std::string& path) {
  std::error_code failure;
  if (!std::filesystem::exists(path, failure)) return Error{"there is no such file", path};
  if (std::filesystem::is_directory(path, failure))
    return Error{"this is a folder, not a session file", path};
  if (std::filesystem::file_size(path, failure) == 0)
    return Error{"the file is empty: nothing was recorded into it", path};
  auto database = SessionDatabase::open(path, SessionDatabase::Access::Read);
  if (!database) return database.error();
  Status ours = check_session_schema(*database);
  const DatabaseFault fault = database->fault();
  if (!ours && fault == DatabaseFault::Busy && can_be_read_without_locks(path)) {
    database = SessionDatabase::open(path, SessionDatabase::Access::Frozen);
    if (!database) return database.error();
    ours = check_session_schema(*database);
  } else if (!ours && (fault == DatabaseFault::CannotWrite || fault == DatabaseFault::Damaged)) {
    // The log's index cannot be created in this folder, or the file is truncated.
    database = SessionDatabase::open(path, fault == DatabaseFault::Damaged ? SessionDatabase::Access::Salvage
                                                                           : SessionDatabase::Access::Frozen);
    if (!database) return database.error();
    ours = check_session_schema(*database);
  }
  if (!ours) return ours.error();
  return database;
}

}  // namespace abrazo
