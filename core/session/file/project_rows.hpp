#pragma once

#include "core/session/file/project.hpp"
#include "core/session/file/session_database.hpp"

namespace abrazo {

/// In place of the project that the file has, in the running transaction.
Status write_project(SessionDatabase& database, const Project& project);

/// Of a database of any version that `check_session_schema` has passed.
Result<ProjectReading> read_project(SessionDatabase& database);

}  // namespace abrazo
