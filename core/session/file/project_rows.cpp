#include "core/session/file/project_rows.hpp"

#include <algorithm>
#include <limits>

#include "core/base/utc_time.hpp"
#include "core/session/file/decisions_json.hpp"
#include "core/session/file/project_annotations.hpp"
#include "core/session/file/project_videos.hpp"
#include "core/session/file/table_reader.hpp"

namespace abrazo {

namespace {

/// Rows of a table `key`, `value`.
Status write_words(SessionDatabase& database, const std::string& table,
                   const std::map<std::string, std::string>& words) {
  auto insert = database.prepare("INSERT INTO " + table + " (key, value) VALUES (?, ?)");
  if (!insert) return insert.error();
  for (const auto& [key, value] : words)
    if (const Status done = insert->bind(0, key).bind(1, value).run(); !done) return done;
  return Done{};
}

std::map<std::string, std::string> read_words(TableReader& tables, const std::string& what,
                                              const std::string& table) {
  std::map<std::string, std::string> words;
  tables.each(what, table, "key, value", [&](const SessionStatement& row) {
    words[row.text(1)] = row.text(2);
    return Status(Done{});
  });
  return words;
}

Status write_markers(SessionDatabase& database, const Markers& markers) {
  if (const Status done = database.execute("DELETE FROM markers"); !done) return done;
  auto insert = database.prepare("INSERT INTO markers (id, time_s, name) VALUES (?, ?, ?)");
  if (!insert) return insert.error();
  for (const Marker& marker : markers.all())
    if (const Status done = insert->bind(0, marker.id).bind(1, marker.time_s).bind(2, marker.name).run();
        !done)
      return done;
  return Done{};
}

Markers read_markers(TableReader& tables, int next_id) {
  std::vector<Marker> markers;
  tables.each("markers", "markers", "time_s, name", [&](const SessionStatement& row) -> Status {
    if (Status good = finite(row, {1}, "the marker '" + row.text(2) + "'"); !good) return good;
    if (row.integer(0) >= std::numeric_limits<int>::max()) return Error{"a marker has no number", {}};
    markers.push_back({static_cast<int>(row.integer(0)), row.real(1), row.text(2)});
    return Done{};
  });
  return Markers::restored(std::move(markers), next_id);
}

/// The project derived from a recording, for files without a saved project.
void take_from_recording(TableReader& tables, Project& project) {
  tables.each("settings", "(SELECT frame + 1 AS id, json FROM settings)", "json",
              [&](const SessionStatement& row) -> Status {
                auto settings = parse_settings(row.text(1), Settings{}, "settings");
                if (!settings) return settings.error();
                project.settings = *settings;
                return Done{};
              });
  tables.each("decisions", "(SELECT frame + 1 AS id, json FROM decisions)", "json",
              [&](const SessionStatement& row) -> Status {
                auto decisions = parse_decisions(row.text(1), "decisions");
                if (!decisions) return decisions.error();
                project.decisions = std::move(*decisions);
                return Done{};
              });
  tables.each("inputs", "inputs", "input", [&](const SessionStatement& row) {
    project.input = row.text(1);
    return Status(Done{});
  });
  tables.each("libraries", "libraries", "coalesce(relative_path, ''), coalesce(absolute_path, '')",
              [&](const SessionStatement& row) {
                project.data.clear();
                DataReference library;
                library.relative_path = row.text(1);
                library.absolute_path = row.text(2);
                if (!library.absolute_path.empty()) project.data.push_back(std::move(library));
                return Status(Done{});
              });
}

/// A row of the views begins like this where it has the markers of a take; its name follows.
constexpr std::string_view markers_key = "markers:";

std::map<std::string, std::string> view_rows(const Project& project) {
  auto rows = project.view;
  for (const auto& [take, markers] : project.take_markers)
    rows[std::string(markers_key) + take] = markers_json(markers);
  return rows;
}

void take_views(std::map<std::string, std::string> rows, Project& project) {
  for (const auto& [key, text] : rows)
    if (key.starts_with(markers_key) && key.size() > markers_key.size())
      if (Markers markers = parse_markers(text); !markers.empty())
        project.take_markers[key.substr(markers_key.size())] = std::move(markers);
  std::erase_if(rows, [](const auto& row) { return row.first.starts_with(markers_key); });
  project.view = std::move(rows);
}

Status take_settings(const std::map<std::string, std::string>& words, Project& project) {
  const auto text = [&](const char* key) {
    const auto found = words.find(key);
    return found == words.end() ? std::string() : found->second;
  };
  project.input = text("input");
  project.presets = text("presets");
  project.library = text("library");
  project.manifest = text("manifest");
  Status good = Done{};
  if (const std::string json = text("settings"); !json.empty()) {
    auto settings = parse_settings(json, Settings{}, "settings");
    settings ? void(project.settings = *settings) : void(good = settings.error());
  }
  if (const std::string json = text("decisions"); !json.empty()) {
    auto decisions = parse_decisions(json, "decisions");
    decisions ? void(project.decisions = *decisions) : void(good = decisions.error());
  }
  return good;
}

int number_in(const std::map<std::string, std::string>& words, const char* key) {
  const auto found = words.find(key);
  if (found == words.end() || found->second.size() > 9) return 1;
  int number = 0;
  for (const char c : found->second) {
    if (c < '0' || c > '9') return 1;
    number = 10 * number + (c - '0');
  }
  return number;
}

}  // namespace

Status write_project(SessionDatabase& database, const Project& project) {
  const Status cleared = database.execute("DELETE FROM project; DELETE FROM view_state");
  if (!cleared) return cleared;
  const std::map<std::string, std::string> words = {
      {"saved_at", utc_now()},
      {"settings", settings_json(project.settings)},
      {"decisions", decisions_json(project.decisions)},
      {"input", project.input},
      {"presets", project.presets},
      {"library", project.library},
      {"manifest", project.manifest},
      {"next_marker", std::to_string(project.markers.next_id())}};
  if (const Status done = write_words(database, "project", words); !done) return done;
  if (const Status done = write_words(database, "view_state", view_rows(project)); !done) return done;
  if (const Status done = write_markers(database, project.markers); !done) return done;
  if (const Status done = write_annotations(database, project.annotations); !done) return done;
  return write_data_and_videos(database, project);
}

Result<ProjectReading> read_project(SessionDatabase& database) {
  ProjectReading reading;
  Project& project = reading.project;
  TableReader tables(database);
  std::vector<std::string> more;
  auto words = read_words(tables, "facts", "project");
  reading.is_saved = words.contains("saved_at");
  if (reading.is_saved) reading.saved_at = words["saved_at"];
  take_views(read_words(tables, "views", "view_state"), project);
  project.annotations = read_annotations(tables);
  read_data_and_videos(tables, project);
  project.markers = read_markers(tables, number_in(words, "next_marker"));
  if (!reading.is_saved)
    take_from_recording(tables, project);
  else if (const Status good = take_settings(words, project); !good)
    more.push_back("its settings or decisions could not be read: " + good.error().text());
  reading.damaged = tables.damaged() + more.size();
  reading.damage = tables.damage();
  reading.damage.insert(reading.damage.end(), more.begin(), more.end());
  return reading;
}

}  // namespace abrazo
