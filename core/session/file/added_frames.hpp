#pragma once

#include <string>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"

namespace abrazo {

class SessionDatabase;

/// Adds the frames of a session file that a session does not have, with the input, library, settings and
/// decisions they were solved with. Times and indices of both are those of one session. Frames that cannot
/// be read are counted as lost. In the running transaction.
/// @param from  may be in the process of being recorded: then what is on disk
Status add_frames(SessionDatabase& session, const std::string& from, const Progress& progress);

}  // namespace abrazo
