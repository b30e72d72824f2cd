#pragma once

#include "core/session/file/project.hpp"
#include "core/session/file/session_database.hpp"

namespace abrazo {

/// Replaces the project in the file, in the running transaction.
Status write_project(SessionDatabase& database, const Project& project);

/// Reads a database that passed `check_session_schema`.
Result<ProjectReading> read_project(SessionDatabase& database);

}  // namespace abrazo
