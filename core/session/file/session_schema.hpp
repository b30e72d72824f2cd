#pragma once

#include <cstdint>

#include "core/session/file/session_database.hpp"

namespace abrazo {

/// "Abrz", in the header of the file: identifies a session file for `file` and other programs.
inline constexpr std::int64_t session_application_id = 0x4162727a;
/// Increased when older programs cannot read the new layout.
inline constexpr std::int64_t session_schema_version = 2;

/// Pages of a file with frames. A frame is some 4 kB: four rows to a page. Every 32nd has its state, 25 kB,
/// and needs further pages.
inline constexpr int recording_page_bytes = 16384;

/// Whether the database has no tables.
Result<bool> is_empty_database(SessionDatabase& database);
/// Creates tables and views in an empty database. Within a transaction.
Status create_session_schema(SessionDatabase& database);
/// Notes in `meta` what the values are, for those who read the file without us.
Status note_units(SessionDatabase& database);
/// Checks that this program can read the database as a session file; the Error says what it is instead.
Status check_session_schema(SessionDatabase& database);

/// Opens a session file for reading, with the log of a crash; the file alone if its folder is read-only.
Result<SessionDatabase> open_session_database(const std::string& path);

}  // namespace abrazo
