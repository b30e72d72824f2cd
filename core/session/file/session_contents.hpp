#pragma once

#include <string>
#include <vector>

#include "core/session/file/session_database.hpp"
#include "core/session/file/session_file.hpp"

namespace abrazo {

/// Content of a session file, known when it is opened.
struct SessionFacts {
  SessionContents contents;
  std::vector<std::string> recovery;  ///< sentences about a file that was cut off or damaged
  bool is_being_recorded = false;
};
/// @return an Error if nothing can be read
Result<SessionFacts> read_facts(SessionDatabase& database);

}  // namespace abrazo
