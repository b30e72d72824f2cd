#include "core/session/file/session_edit.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/atomic_file.hpp"
#include "core/base/utc_time.hpp"
#include "core/session/file/session_database.hpp"
#include "core/session/file/session_schema.hpp"

namespace abrazo {

namespace {

struct Row {
  std::int64_t id = 0;
  std::string name;
};

Result<std::vector<Row>> rows_to_edit(SessionDatabase& database, const TakeEdits& edits) {
  auto query = database.prepare("SELECT id, name FROM takes");
  if (!query) return query.error();
  std::vector<Row> rows;
  while (true) {
    const auto more = query->step();
    if (!more) return more.error();
    if (!*more) return rows;
    Row row{query->integer(0), query->text(1)};
    if (edits.contains(row.name)) rows.push_back(std::move(row));
  }
}

}  // namespace

Status apply_take_edits(SessionDatabase& database, const TakeEdits& edits) {
  const auto rows = rows_to_edit(database, edits);
  if (!rows) return rows.error();
  auto rename = database.prepare("UPDATE takes SET name = ? WHERE id = ?");
  if (!rename) return rename.error();
  auto remove = database.prepare("DELETE FROM takes WHERE id = ?");
  if (!remove) return remove.error();
  for (const Row& row : *rows) {
    const std::optional<std::string>& name = edits.at(row.name);
    const Status done =
        name ? rename->bind(0, std::string_view(*name)).bind(1, row.id).run() : remove->bind(0, row.id).run();
    if (!done) return done;
  }
  return Done{};
}

Status edit_session_takes(const std::string& path, const TakeEdits& edits) {
  if (edits.empty()) return Done{};
  auto database = SessionDatabase::open(path, SessionDatabase::Access::Write);
  if (!database) return database.error();
  const Status known = check_session_schema(*database);
  if (!known) return known;
  const Status begun = database->execute("BEGIN IMMEDIATE");
  if (!begun) return begun;
  const Status edited = apply_take_edits(*database, edits);
  const Status ended = database->execute(edited ? "COMMIT" : "ROLLBACK");
  const Status closed = database->close();
  return !edited ? edited : !ended ? ended : closed;
}

Status end_open_takes(SessionDatabase& database) {
  return database.execute(
      "UPDATE takes SET last_frame = (SELECT max(frame) FROM frames), "
      "end_s = (SELECT time_s FROM frames ORDER BY frame DESC LIMIT 1) WHERE end_s IS NULL");
}

namespace {

/// Of a file that is thrown away if this fails: a journal beside it would only be left over.
Status end_open_runs(const std::string& path) {
  auto database = SessionDatabase::open(path, SessionDatabase::Access::Write);
  if (!database) return database.error();
  Status ended = database->execute("PRAGMA journal_mode=MEMORY");
  if (ended) ended = end_open_takes(*database);
  if (ended) {
    auto runs = database->prepare("UPDATE runs SET ended_at = max(begun_at, ?) WHERE ended_at IS NULL");
    ended = runs ? runs->bind(0, utc_now()).run() : Status(runs.error());
  }
  const Status closed = database->close();
  return ended ? closed : ended;
}

}  // namespace

Status copy_session(const std::string& path, const std::string& copy) {
  std::error_code trouble;
  if (std::filesystem::equivalent(path, copy, trouble))
    return Error{"is the session itself; save it under another name", copy};
  auto database = SessionDatabase::open(path, SessionDatabase::Access::Read);
  if (!database) return database.error();
  const Status known = check_session_schema(*database);
  if (!known) return known;
  AtomicFile whole(copy);
  const std::string partial = whole.partial().string();
  Status done = database->copy_into(partial);
  if (done) done = end_open_runs(partial);
  if (done) done = whole.commit();
  if (!done) return Error{done.error().message, copy};
  return Done{};
}

}  // namespace abrazo
