#include "core/session/file/session_contents.hpp"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "core/session/file/decisions_json.hpp"
#include "core/session/file/project_annotations.hpp"
#include "core/session/file/session_schema.hpp"
#include "core/session/file/table_reader.hpp"
#include "core/session/frames/time_place.hpp"

namespace abrazo {

namespace {

std::uint64_t counted(const SessionStatement& row, int column) {
  return static_cast<std::uint64_t>(std::max<std::int64_t>(0, row.integer(column)));
}

/// Calls `take` on every row; an unreadable table is reported, with its readable rows.
class Tables {
 public:
  Tables(SessionDatabase& database, std::vector<std::string>& damage)
      : database_(database), damage_(damage) {}

  void rows(const std::string& what, const std::string& sql,
            const std::function<Status(const SessionStatement&)>& take) {
    auto statement = database_.prepare(sql);
    if (!statement) return damaged(what, statement.error());
    while (true) {
      const auto row = statement->step();
      if (!row) return damaged(what, row.error());
      if (!*row) return;
      if (const Status taken = take(*statement); !taken) damaged(what, taken.error());
    }
  }

 private:
  void damaged(const std::string& what, const Error& why) {
    damage_.push_back("not all of its " + what + " can be read: " + why.message);
  }
  SessionDatabase& database_;
  std::vector<std::string>& damage_;
};

std::vector<std::string> names_in(const std::string& json) {
  const auto parsed = nlohmann::json::parse(json, nullptr, false);
  std::vector<std::string> names;
  if (parsed.is_array())
    for (const auto& name : parsed)
      if (name.is_string()) names.push_back(name.get<std::string>());
  return names;
}

void read_runs(Tables& tables, SessionContents& contents) {
  tables.rows("sessions",
              "SELECT id, begun_at, program, offset_s, coalesce(first_frame, offset_frames), ended_at, lost, "
              "first_frame IS NULL FROM runs ORDER BY coalesce(first_frame, offset_frames), id",
              [&](const SessionStatement& row) -> Status {
                SessionRun run;
                run.id = static_cast<int>(row.integer(0));
                run.begun_at = row.text(1);
                contents.program = row.text(2);
                run.offset_s = row.real(3);
                run.first_frame = counted(row, 4);
                run.finished = !row.is_null(5);
                run.lost = counted(row, 6);
                run.frames = row.integer(7) != 0 ? 0 : 1;  // how many will be seen
                contents.runs.push_back(run);
                return Done{};
              });
}

void read_libraries(Tables& tables, SessionContents& contents) {
  tables.rows(
      "libraries",
      "SELECT id, relative_path, absolute_path, name, pairs, fingerprint, excluded_takes, first_frame "
      "FROM libraries ORDER BY first_frame, id",
      [&](const SessionStatement& row) -> Status {
        contents.libraries.push_back({static_cast<int>(row.integer(0)), row.text(1), row.text(2), row.text(3),
                                      counted(row, 4), row.text(5), names_in(row.text(6)), counted(row, 7)});
        return Done{};
      });
  tables.rows("inputs", "SELECT id, input, first_frame FROM inputs ORDER BY first_frame, id",
              [&](const SessionStatement& row) -> Status {
                contents.inputs.push_back({static_cast<int>(row.integer(0)), row.text(1), counted(row, 2)});
                return Done{};
              });
}

void read_tracks(Tables& tables, SessionContents& contents) {
  tables.rows("settings", "SELECT frame, time_s, json FROM settings ORDER BY frame",
              [&](const SessionStatement& row) -> Status {
                auto settings = parse_settings(row.text(2), Settings{}, "settings");
                if (!settings) return settings.error();
                contents.settings.push_back({counted(row, 0), row.real(1), std::move(*settings)});
                return Done{};
              });
  tables.rows("decisions", "SELECT frame, time_s, json FROM decisions ORDER BY frame",
              [&](const SessionStatement& row) -> Status {
                auto decisions = parse_decisions(row.text(2), "decisions");
                if (!decisions) return decisions.error();
                contents.decisions.push_back({counted(row, 0), row.real(1), std::move(*decisions)});
                return Done{};
              });
  tables.rows("markers", "SELECT id, time_s, name FROM markers ORDER BY time_s, id",
              [&](const SessionStatement& row) -> Status {
                contents.markers.push_back({static_cast<int>(row.integer(0)), row.real(1), row.text(2)});
                return Done{};
              });
}

/// Annotations of the session itself, not of takes of the library.
void read_annotated(SessionDatabase& database, SessionContents& contents, std::vector<std::string>& damage) {
  TableReader tables(database);
  const AnnotationBook book = read_annotations(tables);
  if (const auto session = book.find(""); session != book.end())
    contents.annotations = tiers_of(session->second);
  damage.insert(damage.end(), tables.damage().begin(), tables.damage().end());
}

void read_performers(Tables& tables, SessionContents& contents) {
  tables.rows(
      "performers",
      "SELECT p.id, p.name, count(q.performer), min(q.arrived_s), max(q.arrived_s) FROM performers p "
      "LEFT JOIN poses q INDEXED BY poses_by_performer ON q.performer = p.id GROUP BY p.id ORDER BY p.id",
      [&](const SessionStatement& row) -> Status {
        contents.performers.push_back(
            {static_cast<int>(row.integer(0)), row.text(1), counted(row, 2), row.real(3), row.real(4)});
        return Done{};
      });
}

void read_takes(Tables& tables, SessionContents& contents) {
  tables.rows("takes",
              "SELECT id, name, begun_at, start_s, end_s, first_frame, last_frame FROM takes ORDER BY id",
              [&](const SessionStatement& row) -> Status {
                SessionTake take;
                take.id = static_cast<int>(row.integer(0));
                take.name = row.text(1);
                take.begun_at = row.text(2);
                take.start_s = row.real(3);
                take.first_frame = counted(row, 5);
                take.interrupted = row.is_null(4);
                take.end_s = take.interrupted ? contents.last_s : row.real(4);
                take.last_frame = take.interrupted ? contents.last_frame : counted(row, 6);
                contents.takes.push_back(take);
                return Done{};
              });
}

void read_frames(Tables& tables, SessionContents& contents) {
  tables.rows("frames", "SELECT frame, time_s FROM frames NOT INDEXED ORDER BY frame LIMIT 1",
              [&](const SessionStatement& row) -> Status {
                contents.first_frame = contents.last_frame = counted(row, 0);
                contents.first_s = contents.last_s = row.real(1);
                contents.frames = 1;
                return Done{};
              });
  // The index survives where the table does not, and is quick to count.
  for (const char* how : {"NOT INDEXED ORDER BY frame", "INDEXED BY frames_by_time ORDER BY time_s"})
    tables.rows("frames", std::string("SELECT frame, time_s FROM frames ") + how + " DESC LIMIT 1",
                [&](const SessionStatement& row) -> Status {
                  if (counted(row, 0) < contents.last_frame) return Done{};
                  contents.last_frame = counted(row, 0);
                  contents.last_s = std::max(contents.last_s, row.real(1));
                  return Done{};
                });
  tables.rows("frames", "SELECT count(*) FROM frames INDEXED BY frames_by_time",
              [&](const SessionStatement& row) -> Status {
                contents.frames = counted(row, 0);
                return Done{};
              });
}

/// The frames of each session: up to the first of the next that has any.
void bound_runs(SessionDatabase& database, SessionContents& contents) {
  std::uint64_t end = contents.last_frame + 1;
  for (auto run = contents.runs.rbegin(); run != contents.runs.rend(); ++run) {
    if (run->frames == 0 || end <= run->first_frame) {
      run->frames = 0;
      continue;
    }
    run->frames = end - run->first_frame;
    for (const bool first : {true, false}) {
      const std::uint64_t frame = first ? run->first_frame : end - 1;
      auto row = database.prepare("SELECT time_s FROM frames WHERE frame = ?");
      if (!row) continue;
      const auto stepped = row->bind(0, frame).step();
      if (stepped && *stepped) (first ? run->first_s : run->last_s) = row->real(0);
    }
    end = run->first_frame;
  }
}

/// Reads all small tables. Unreadable parts are left out and reported in `damage`, one sentence each.
SessionContents read_contents(SessionDatabase& database, std::vector<std::string>& damage) {
  SessionContents contents;
  Tables tables(database, damage);
  read_frames(tables, contents);
  read_runs(tables, contents);
  bound_runs(database, contents);
  read_libraries(tables, contents);
  read_tracks(tables, contents);
  read_annotated(database, contents, damage);
  read_performers(tables, contents);
  read_takes(tables, contents);
  // Each kind of damage is reported once.
  std::vector<std::string> once;
  for (std::string& sentence : damage)
    if (std::find(once.begin(), once.end(), sentence) == once.end()) once.push_back(std::move(sentence));
  damage = std::move(once);
  return contents;
}

/// Sentences about sessions that were cut off: the recorded length, and the open take.
std::vector<std::string> recovery_of(const SessionContents& contents) {
  std::vector<std::string> lines;
  for (const SessionRun& run : contents.runs) {
    if (!run.finished)
      lines.push_back(run.frames == 0 ? "the recording was cut off before its first frame"
                                      : "the recording was cut off; recovered " + std::to_string(run.frames) +
                                            " frames up to " + clock_text(run.last_s));
    if (run.lost > 0)
      lines.push_back(
          std::to_string(run.lost) +
          " frames and poses are missing: they could not be written in time, or not read when the history "
          "was saved");
  }
  for (const SessionTake& take : contents.takes)
    if (take.interrupted)
      lines.push_back("the take '" + take.name + "' was still being recorded; it ends at " +
                      clock_text(take.end_s));
  return lines;
}

}  // namespace

Result<SessionFacts> read_facts(SessionDatabase& database) {
  SessionFacts facts;
  facts.is_being_recorded = database.is_held_elsewhere();
  std::vector<std::string> damage;
  facts.contents = read_contents(database, damage);
  if (!facts.is_being_recorded) facts.recovery = recovery_of(facts.contents);
  if (database.lacks_log() && !facts.recovery.empty())
    facts.recovery.insert(facts.recovery.begin(), "its log '" + log_name(database) +
                                                      "' is not beside it; copy that too, if this is a copy");
  if (database.is_salvage())
    facts.recovery.insert(facts.recovery.begin(),
                          "the file is damaged or cut short; what can still be read is shown");
  facts.recovery.insert(facts.recovery.end(), damage.begin(), damage.end());
  if (facts.contents.runs.empty() && facts.contents.frames == 0 && !damage.empty())
    return Error{"nothing of the file can be read; " + damage.front(), database.path()};
  return facts;
}

}  // namespace abrazo
