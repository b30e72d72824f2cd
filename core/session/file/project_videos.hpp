#pragma once

#include "core/session/file/project.hpp"
#include "core/session/file/session_database.hpp"
#include "core/session/file/table_reader.hpp"

namespace abrazo {

/// Replaces the file's data references and its videos with sync points, cameras and picked points, in the
/// running transaction.
Status write_data_and_videos(SessionDatabase& database, const Project& project);

/// Reads all valid rows. A video whose file is not among the data has no file.
void read_data_and_videos(TableReader& tables, Project& project);

}  // namespace abrazo
