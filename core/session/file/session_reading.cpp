#include "core/session/file/session_reading.hpp"

#include "core/session/file/project_rows.hpp"
#include "core/session/file/session_contents.hpp"
#include "core/session/file/session_schema.hpp"

namespace abrazo {

Result<SessionReading> read_session(const std::string& path) {
  auto database = open_session_database(path);
  if (!database) return database.error();
  auto facts = read_facts(*database);
  if (!facts) return facts.error();
  auto project = read_project(*database);
  if (!project) return project.error();
  auto frames = RecordedFrames::over(std::move(*database));
  if (!frames) return frames.error();
  return SessionReading{std::move(facts->contents), std::move(facts->recovery), facts->is_being_recorded,
                        std::move(*project), std::move(*frames)};
}

}  // namespace abrazo
