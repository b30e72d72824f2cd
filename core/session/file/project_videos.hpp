#pragma once

#include "core/session/file/project.hpp"
#include "core/session/file/session_database.hpp"
#include "core/session/file/table_reader.hpp"

namespace abrazo {

/// References to data, and videos with their sync points, cameras and picked points, in place of those of the
/// file; in the running transaction.
Status write_data_and_videos(SessionDatabase& database, const Project& project);

/// What can be read; a video whose file is not among the data is one without.
void read_data_and_videos(TableReader& tables, Project& project);

}  // namespace abrazo
