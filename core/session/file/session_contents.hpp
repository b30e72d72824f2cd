#pragma once

#include <string>
#include <vector>

#include "core/session/file/session_database.hpp"
#include "core/session/file/session_file.hpp"

namespace abrazo {

/// What is known of a session file when it is opened.
struct SessionFacts {
  SessionContents contents;
  std::vector<std::string> recovery;  ///< what is to be said of one that was cut off or damaged
  bool is_being_recorded = false;
};
/// @return an Error when nothing of it can be read
Result<SessionFacts> read_facts(SessionDatabase& database);

}  // namespace abrazo
