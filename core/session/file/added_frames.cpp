#include "core/session/file/added_frames.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/utc_time.hpp"
#include "core/session/file/frame_row.hpp"
#include "core/session/file/library_reference.hpp"
#include "core/session/file/session_database.hpp"
#include "core/session/file/session_schema.hpp"

namespace abrazo {

namespace {

constexpr std::uint64_t frames_between_reports = 512;

using Ids = std::map<std::int64_t, std::int64_t>;

/// Frames without a gap, both ends inclusive.
struct Stretch {
  std::int64_t first = 0, last = 0;
  std::uint64_t count() const { return static_cast<std::uint64_t>(last - first) + 1; }
};

/// Calls `take` on every row.
template <typename Take>
Status each_stored_row(SessionStatement& rows, Take&& take) {
  while (true) {
    const auto more = rows.step();
    if (!more) return more.error();
    if (!*more) break;
    if (const Status taken = take(rows); !taken) return taken;
  }
  rows.reset();
  return Done{};
}

/// Indices of all frames, ascending; from the index by time, which is small.
Result<std::vector<std::int64_t>> frames_in(SessionDatabase& database) {
  auto rows = database.prepare("SELECT frame FROM frames INDEXED BY frames_by_time ORDER BY time_s");
  if (!rows) return rows.error();
  std::vector<std::int64_t> frames;
  const Status read = each_stored_row(*rows, [&](const SessionStatement& row) -> Status {
    frames.push_back(row.integer(0));
    return Done{};
  });
  if (!read) return read.error();
  std::ranges::sort(frames);
  return frames;
}

std::vector<Stretch> lacking(const std::vector<std::int64_t>& all, const std::vector<std::int64_t>& known) {
  std::vector<Stretch> stretches;
  std::vector<std::int64_t> frames;
  std::ranges::set_difference(all, known, std::back_inserter(frames));
  for (const std::int64_t frame : frames) {
    if (!stretches.empty() && stretches.back().last + 1 == frame)
      stretches.back().last = frame;
    else
      stretches.push_back({frame, frame});
  }
  return stretches;
}

/// Which row was in force at a frame: the last that begins not after it, else the first of all.
constexpr const char* row_in_force =
    " ORDER BY first_frame <= ?1 DESC, iif(first_frame <= ?1, -first_frame, first_frame), id LIMIT 1";

/// Adds the rows of one file to another, whose ids are other ones.
class FrameCopy {
 public:
  FrameCopy(SessionDatabase& to, SessionDatabase& from, std::vector<Stretch> stretches)
      : to_(to), from_(from), stretches_(std::move(stretches)) {}

  Status run(const Progress& progress) {
    if (const Status done = addLibraries(); !done) return done;
    if (const Status done = addInputs(); !done) return done;
    for (const char* track : {"settings", "decisions"})
      if (const Status done = addTrack(track); !done) return done;
    if (const Status done = addFrames(progress); !done) return done;
    return addRun();
  }

 private:
  /// An id before or behind all others: rows are listed by id, in the order of their frames.
  Result<std::int64_t> freeId(const std::string& table, std::int64_t first_frame) {
    auto ids =
        to_.prepare("SELECT coalesce(min(id), 1), coalesce(max(id), 0), min(first_frame) FROM " + table);
    if (!ids) return ids.error();
    if (const auto row = ids->step(); !row) return row.error();
    const bool is_earliest = !ids->is_null(2) && first_frame < ids->integer(2);
    return is_earliest ? ids->integer(0) - 1 : ids->integer(1) + 1;
  }

  Status addLibraries() {
    auto rows = from_.prepare(
        "SELECT id, absolute_path, name, pairs, fingerprint, excluded_takes, first_frame FROM libraries "
        "ORDER BY first_frame");
    if (!rows) return rows.error();
    return each_stored_row(*rows, [&](const SessionStatement& row) -> Status {
      const auto known = knownLibrary(row);
      if (!known) return known.error();
      const auto id = *known ? Result<std::int64_t>(**known) : freeId("libraries", row.integer(6));
      if (!id) return id.error();
      if (const Status noted = *known ? noteLibrary(*id, row) : insertLibrary(*id, row); !noted) return noted;
      libraries_[row.integer(0)] = *id;
      return addPairs(row.integer(0), *id);
    });
  }

  /// The row of the same library that is in force there; none if it is another.
  Result<std::optional<std::int64_t>> knownLibrary(const SessionStatement& row) {
    auto found = to_.prepare(
        std::string("SELECT id, absolute_path, name, pairs, fingerprint, excluded_takes FROM libraries") +
        row_in_force);
    if (!found) return found.error();
    const auto stepped = found->bind(0, row.integer(6)).step();
    if (!stepped) return stepped.error();
    if (!*stepped) return std::optional<std::int64_t>();
    const std::string fingerprint = row.text(4), other = found->text(4);
    const bool is_same = found->text(1) == row.text(1) && found->text(2) == row.text(2) &&
                         found->integer(3) == row.integer(3) && found->text(5) == row.text(5) &&
                         (fingerprint.empty() || other.empty() || fingerprint == other);
    return is_same ? std::optional(found->integer(0)) : std::nullopt;
  }

  Status noteLibrary(std::int64_t id, const SessionStatement& row) {
    auto noted = to_.prepare(
        "UPDATE libraries SET first_frame = min(first_frame, ?), fingerprint = coalesce(fingerprint, "
        "nullif(?, '')) WHERE id = ?");
    if (!noted) return noted.error();
    const std::string fingerprint = row.text(4);
    return noted->bind(0, row.integer(6)).bind(1, std::string_view(fingerprint)).bind(2, id).run();
  }

  Status insertLibrary(std::int64_t id, const SessionStatement& row) {
    auto added = to_.prepare(
        "INSERT INTO libraries (id, relative_path, absolute_path, name, pairs, fingerprint, excluded_takes, "
        "first_frame) VALUES (?, nullif(?, ''), nullif(?, ''), ?, ?, nullif(?, ''), ?, ?)");
    if (!added) return added.error();
    const std::string path = row.text(1), name = row.text(2), fingerprint = row.text(4), takes = row.text(5);
    const std::string relative = path.empty() ? std::string() : path_from_session(to_.path(), path);
    added->bind(0, id).bind(1, std::string_view(relative)).bind(2, std::string_view(path));
    added->bind(3, std::string_view(name)).bind(4, row.integer(3)).bind(5, std::string_view(fingerprint));
    return added->bind(6, std::string_view(takes)).bind(7, row.integer(6)).run();
  }

  Status addPairs(std::int64_t library, std::int64_t added) {
    auto rows = from_.prepare("SELECT pair, take, frame, swapped, label FROM pairs WHERE library = ?");
    auto insert = to_.prepare("INSERT OR IGNORE INTO pairs VALUES (?, ?, ?, ?, ?, ?)");
    if (!rows || !insert) return rows ? insert.error() : rows.error();
    rows->bind(0, library);
    return each_stored_row(*rows, [&](const SessionStatement& row) -> Status {
      const std::string take = row.text(1), label = row.text(4);
      insert->bind(0, added).bind(1, row.integer(0)).bind(2, std::string_view(take));
      insert->bind(3, row.integer(2)).bind(4, row.integer(3));
      row.is_null(4) ? insert->bind_null(5) : insert->bind(5, std::string_view(label));
      return insert->run();
    });
  }

  Status addInputs() {
    auto rows = from_.prepare("SELECT id, input, first_frame FROM inputs ORDER BY first_frame");
    if (!rows) return rows.error();
    return each_stored_row(*rows, [&](const SessionStatement& row) -> Status {
      const std::string input = row.text(1);
      auto found = to_.prepare(std::string("SELECT id, input FROM inputs") + row_in_force);
      if (!found) return found.error();
      const auto stepped = found->bind(0, row.integer(2)).step();
      if (!stepped) return stepped.error();
      const bool is_known = *stepped && found->text(1) == input;
      const auto id = is_known ? Result<std::int64_t>(found->integer(0)) : freeId("inputs", row.integer(2));
      if (!id) return id.error();
      inputs_[row.integer(0)] = *id;
      auto noted = to_.prepare(is_known ? "UPDATE inputs SET first_frame = min(first_frame, ?2) WHERE id = ?1"
                                        : "INSERT INTO inputs (id, first_frame, input) VALUES (?1, ?2, ?3)");
      if (!noted) return noted.error();
      noted->bind(0, *id).bind(1, row.integer(2));
      if (!is_known) noted->bind(2, std::string_view(input));
      return noted->run();
    });
  }

  /// What holds at the begin of each stretch, and its changes.
  Status addTrack(const std::string& table) {
    auto held = from_.prepare("SELECT json FROM " + table + " WHERE frame <= ? ORDER BY frame DESC LIMIT 1");
    auto changes = from_.prepare("SELECT frame, time_s, json FROM " + table +
                                 " WHERE frame > ? AND frame <= ? ORDER BY frame");
    auto time = from_.prepare("SELECT time_s FROM frames WHERE frame = ?");
    auto insert = to_.prepare("INSERT OR REPLACE INTO " + table + " VALUES (?, ?, ?)");
    for (const auto* statement : {&held, &changes, &time, &insert})
      if (!*statement) return statement->error();
    for (const Stretch& stretch : stretches_) {
      held->bind(0, stretch.first);
      time->bind(0, stretch.first);
      Status done = each_stored_row(*time, [&](const SessionStatement& frame) {
        return each_stored_row(*held, [&](const SessionStatement& row) {
          return insert->bind(0, stretch.first).bind(1, frame.real(0)).bind(2, row.text(0)).run();
        });
      });
      changes->bind(0, stretch.first).bind(1, stretch.last);
      if (done)
        done = each_stored_row(*changes, [&](const SessionStatement& row) {
          return insert->bind(0, row.integer(0)).bind(1, row.real(1)).bind(2, row.text(2)).run();
        });
      if (!done) return done;
    }
    return removeRepeated(table);
  }

  /// Each file begins with what holds there, which is no change.
  Status removeRepeated(const std::string& table) {
    auto rows = to_.prepare("SELECT frame, json FROM " + table + " ORDER BY frame");
    if (!rows) return rows.error();
    std::vector<std::int64_t> repeated;
    std::optional<std::string> before;
    const Status read = each_stored_row(*rows, [&](const SessionStatement& row) -> Status {
      std::string json = row.text(1);
      if (before == json) repeated.push_back(row.integer(0));
      before = std::move(json);
      return Done{};
    });
    if (!read) return read;
    auto remove = to_.prepare("DELETE FROM " + table + " WHERE frame = ?");
    if (!remove) return remove.error();
    for (const std::int64_t frame : repeated)
      if (const Status removed = remove->bind(0, frame).run(); !removed) return removed;
    return Done{};
  }

  Status addFrames(const Progress& progress) {
    auto rows = from_.prepare("SELECT " + frame_columns() +
                              ", checksum FROM frames WHERE frame BETWEEN ? AND ? ORDER BY frame");
    auto insert = to_.prepare(frame_insert());
    if (!rows || !insert) return rows ? insert.error() : rows.error();
    std::uint64_t all = 0, seen = 0;
    for (const Stretch& stretch : stretches_) all += stretch.count();
    for (const Stretch& stretch : stretches_) {
      rows->bind(0, stretch.first).bind(1, stretch.last);
      const Status added = each_stored_row(*rows, [&](const SessionStatement& stored) -> Status {
        if (seen++ % frames_between_reports == 0 &&
            !report(progress, static_cast<double>(seen) / static_cast<double>(all), "saving the history"))
          return Error{"cancelled", to_.path()};
        auto row = read_row(stored);
        if (!row) return ++lost_, Done{};
        if (row->library) row->library = libraries_[*row->library];
        if (row->input) row->input = inputs_[*row->input];
        bind_row(*insert, *row);
        return insert->run();
      });
      if (!added) return added;
    }
    return Done{};
  }

  /// Frames before all others, or behind a gap, are a run; those that continue one belong to it.
  Status addRun() {
    const std::int64_t first = stretches_.front().first;
    auto before = to_.prepare(
        "SELECT EXISTS (SELECT 1 FROM frames WHERE frame = ?1 - 1) OR (EXISTS (SELECT 1 FROM runs WHERE "
        "first_frame < ?1) AND EXISTS (SELECT 1 FROM runs WHERE first_frame > ?1))");
    if (!before) return before.error();
    if (const auto row = before->bind(0, first).step(); !row) return row.error();
    const bool continues = before->integer(0) != 0;
    before->reset();
    const auto lost = from_.integer("SELECT sum(lost) FROM runs");
    const auto begun = from_.text("SELECT min(begun_at) FROM runs");
    const auto program = from_.text("SELECT program FROM runs ORDER BY id LIMIT 1");
    if (!lost || !begun || !program) return !lost ? lost.error() : !begun ? begun.error() : program.error();
    const auto lost_in_all = static_cast<std::int64_t>(lost_) + lost->value_or(0);
    if (continues) {
      auto run = to_.prepare(
          "UPDATE runs SET lost = lost + ?, ended_at = coalesce(ended_at, ?) WHERE id = "
          "(SELECT max(id) FROM runs WHERE first_frame < ?)");
      if (!run) return run.error();
      return run->bind(0, lost_in_all).bind(1, utc_now()).bind(2, first).run();
    }
    const auto id = freeId("runs", first);
    if (!id) return id.error();
    auto run = to_.prepare("INSERT INTO runs VALUES (?, ?, ?, 0, 0, ?, ?, ?)");
    if (!run) return run.error();
    run->bind(0, *id).bind(1, begun->value_or("")).bind(2, program->value_or("")).bind(3, first);
    return run->bind(4, utc_now()).bind(5, lost_in_all).run();
  }

  SessionDatabase& to_;
  SessionDatabase& from_;
  std::vector<Stretch> stretches_;
  Ids libraries_, inputs_;
  std::uint64_t lost_ = 0;
};

}  // namespace

Status add_frames(SessionDatabase& session, const std::string& from, const Progress& progress) {
  auto database = open_session_database(from);
  if (!database) return database.error();
  const auto all = frames_in(*database);
  const auto known = frames_in(session);
  if (!all || !known) return !all ? all.error() : known.error();
  std::vector<Stretch> stretches = lacking(*all, *known);
  if (stretches.empty()) return Done{};
  return FrameCopy(session, *database, std::move(stretches)).run(progress);
}

}  // namespace abrazo
