#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/base/result.hpp"

namespace abrazo {

class SessionDatabase;

/// Of a take, by its name in the file: what it is called from now on; nothing takes it off the list. Its
/// frames stay in any case.
using TakeEdits = std::map<std::string, std::optional<std::string>>;

/// Renames takes of a session file or takes them off its list, all or none. Names that the file does not have
/// are passed over. Not while it is being recorded.
Status edit_session_takes(const std::string& path, const TakeEdits& edits);

/// The same in a running transaction.
Status apply_take_edits(SessionDatabase& database, const TakeEdits& edits);

/// A copy of a whole session as one file, also of one that is being recorded: with all that is on disk by
/// then. An existing file is replaced when the copy is complete.
Status copy_session(const std::string& path, const std::string& copy);

}  // namespace abrazo
