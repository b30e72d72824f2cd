#pragma once

#include <functional>
#include <memory>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/session/file/session_file.hpp"

namespace abrazo {

/// Result of solving a session again.
struct SessionReplay {
  std::uint64_t frames = 0;   ///< solved again
  std::uint64_t differ = 0;   ///< frames whose result is not identical to the recorded bits
  std::uint64_t skipped = 0;  ///< before the first kept state, of another library, or after a damaged frame
  std::string note;           ///< why frames were skipped; empty if none were
};

/// Solves the frames of [from_s, to_s] again, from the recorded inputs with the recorded settings, decisions
/// and fresh starts: the frames are complete, including what a file does not keep (mesh, morph steps).
/// @param library of the recording, see LibrarySearch; its fingerprint is checked
/// @param each     is given every frame in order, time and index as in the session; frames that were skipped
///                 are not passed on
Result<SessionReplay> re_solve_session(const SessionRecord& session,
                                       std::shared_ptr<const MotionLibrary> library, double from_s,
                                       double to_s, const std::function<Status(const FrameSnapshot&)>& each,
                                       const Progress& progress = {});

}  // namespace abrazo
