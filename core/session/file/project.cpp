#include "core/session/file/project.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>

#include "core/base/atomic_file.hpp"
#include "core/session/file/project_rows.hpp"
#include "core/session/file/session_database.hpp"
#include "core/session/file/session_schema.hpp"

namespace abrazo {

namespace fs = std::filesystem;

namespace {

/// Runs a function in one transaction: all or nothing.
Status in_transaction(SessionDatabase& database, const std::function<Status()>& work) {
  if (const Status begun = database.execute("BEGIN IMMEDIATE"); !begun) return begun;
  Status done = work();
  if (done) done = database.execute("COMMIT");
  if (!done) (void)database.execute("ROLLBACK");
  return done;
}

Status create(const std::string& path, const Project& project) {
  AtomicFile file(path);
  {
    auto database = SessionDatabase::open(file.partial().string(), SessionDatabase::Access::Create);
    if (!database) return Error{database.error().message, path};
    // The file is thrown away when it does not come to be: a journal beside it would only be left over.
    if (const auto set = database->execute("PRAGMA journal_mode=MEMORY"); !set)
      return Error{set.error().message, path};
    const Status made = in_transaction(*database, [&] {
      const Status created = create_session_schema(*database);
      return created ? write_project(*database, project) : created;
    });
    if (!made) return Error{made.error().message, path};
    if (const Status closed = database->close(); !closed) return Error{closed.error().message, path};
  }
  return file.commit();
}

/// Opens a file that is there for writing.
Result<SessionDatabase> open_to_write(const std::string& path) {
  auto database = SessionDatabase::open(path, SessionDatabase::Access::Write);
  if (!database) return database.error();
  if (const Status ours = check_session_schema(*database); !ours) return ours.error();
  return database;
}

}  // namespace

bool is_same_work(const Project& a, const Project& b) {
  const auto takes = [](const std::map<std::string, Markers>& x, const std::map<std::string, Markers>& y) {
    return std::ranges::equal(x, y, [](const auto& one, const auto& other) {
      return one.first == other.first && one.second.all() == other.second.all();
    });
  };
  const auto videos = [](const ProjectVideo& x, ProjectVideo y) {
    y.data = x.data;
    return x == y;
  };
  return a.settings == b.settings && a.decisions.pinned == b.decisions.pinned &&
         a.decisions.vetoes == b.decisions.vetoes && a.decisions.role_control == b.decisions.role_control &&
         a.markers.all() == b.markers.all() && takes(a.take_markers, b.take_markers) &&
         std::ranges::equal(a.videos, b.videos, videos) && a.annotations == b.annotations;
}

Status save_project(const std::string& path, const Project& project) {
  std::error_code failure;
  if (fs::is_directory(path, failure)) return Error{"this is a folder; name a file in it", path};
  const bool is_there = fs::exists(path, failure) && fs::file_size(path, failure) > 0;
  if (!is_there) return create(path, project);
  auto database = open_to_write(path);
  if (!database) return database.error();
  const Status saved = in_transaction(*database, [&] { return write_project(*database, project); });
  const Status closed = database->close();
  return saved ? closed : saved;
}

Result<ProjectReading> read_project(const std::string& path) {
  auto database = open_session_database(path);
  if (!database) return database.error();
  return read_project(*database);
}

Result<Project> load_project(const std::string& path) {
  auto reading = read_project(path);
  if (!reading) return reading.error();
  return std::move(reading->project);
}

}  // namespace abrazo
