#pragma once

#include <cstdint>

#include "core/session/file/session_database.hpp"

namespace abrazo {

/// "Abrz", in the header of the file: identifies a session file for `file` and other programs.
inline constexpr std::int64_t session_application_id = 0x4162727a;
/// Increased when programs of the version before cannot read the new layout.
inline constexpr std::int64_t session_schema_version = 1;

/// Whether the database has no tables.
Result<bool> is_empty_database(SessionDatabase& database);
/// Creates tables and views in an empty database. Within a transaction.
Status create_session_schema(SessionDatabase& database);
/// Checks that this program can read the database as a session file; the Error says what it is instead.
Status check_session_schema(SessionDatabase& database);

/// The name of its log, for messages.
std::string log_name(const SessionDatabase& database);

/// Opens a session file for reading, with the log of a crash; the file alone if its folder is read-only, or
/// on a disk that locks no files.
Result<SessionDatabase> open_session_database(const std::string& path);

}  // namespace abrazo
