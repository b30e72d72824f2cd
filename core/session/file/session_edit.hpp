#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/base/result.hpp"

namespace abrazo {

class SessionDatabase;

/// New names by the name in the file; none removes the take from the list. Its frames stay in either case.
using TakeEdits = std::map<std::string, std::optional<std::string>>;

/// Renames or removes takes of a session file, all or none. Unknown names are ignored. An Error while the
/// file is being recorded.
Status edit_session_takes(const std::string& path, const TakeEdits& edits);

/// The same in a running transaction.
Status apply_take_edits(SessionDatabase& database, const TakeEdits& edits);

/// Takes without an end end with the last frame.
Status end_open_takes(SessionDatabase& database);

/// Copies a whole session to one file, also during recording: with everything on disk by then. Nobody records
/// into the copy: its runs and takes have an end. It appears complete, and replaces an existing file, or not
/// at all.
Status copy_session(const std::string& path, const std::string& copy);

}  // namespace abrazo
