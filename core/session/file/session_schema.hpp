#pragma once

#include <cstdint>

#include "core/session/file/session_database.hpp"

namespace abrazo {

/// "Abrz", in the header of the file: what `file` and other programs tell a session file by.
inline constexpr std::int64_t session_application_id = 0x4162727a;
/// Raised when an older program could not read the file.
inline constexpr std::int64_t session_schema_version = 2;

/// Whether nothing was ever put into the database.
Result<bool> is_empty_database(SessionDatabase& database);
/// Creates tables and views in an empty database. Within a transaction.
Status create_session_schema(SessionDatabase& database);
/// The error says what it is instead of a session file that this program can read.
Status check_session_schema(SessionDatabase& database);

/// A session file for reading, with what a crash left beside it; where its folder cannot be written, the file
/// alone.
Result<SessionDatabase> open_session_database(const std::string& path);

}  // namespace abrazo
