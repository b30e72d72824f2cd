#pragma once

#include <cstdint>

#include "core/base/result.hpp"
#include "core/session/file/session_database.hpp"

namespace abrazo {

/// The tables of a project, from version 2 on: see docs/session-file.md.
extern const char* const project_tables;

/// Migrates an older version to the present one, in the running transaction. Intervals of version 1 become
/// annotations of the session.
Status migrate_session_schema(SessionDatabase& database);
/// The version of a file that passed `check_session_schema`.
Result<std::int64_t> session_version(SessionDatabase& database);

}  // namespace abrazo
