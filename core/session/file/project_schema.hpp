#pragma once

#include <cstdint>

#include "core/base/result.hpp"
#include "core/session/file/session_database.hpp"

namespace abrazo {

/// The tables of a project, from version 2 on: see docs/session-file.md.
extern const char* const project_tables;

/// From an older version to this one, in the running transaction. What version 1 noted as intervals becomes
/// annotations of the session.
Status migrate_session_schema(SessionDatabase& database);
/// The version of a file that `check_session_schema` has passed.
Result<std::int64_t> session_version(SessionDatabase& database);

}  // namespace abrazo
