#pragma once

#include <string>
#include <vector>

#include "core/session/file/session_database.hpp"
#include "core/session/file/session_file.hpp"

namespace abrazo {

/// Reads all small tables. What cannot be read is left out and said in `damage`, one sentence each.
SessionContents read_contents(SessionDatabase& database, std::vector<std::string>& damage);

/// What is to be said of sessions that were cut off: how much is there, and which take was open.
std::vector<std::string> recovery_of(const SessionContents& contents);

}  // namespace abrazo
