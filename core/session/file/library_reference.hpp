#pragma once

#include <memory>
#include <string>

#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/session/file/session_file.hpp"

namespace abrazo {

/// 16 hexadecimal digits over everything that affects results: takes, pairs, poses, meshes, bodies.
std::string library_fingerprint(const MotionLibrary& library);

/// Paths at which to look for a session's library: relative to the session file, then the absolute path at
/// recording. Empty for a library that was never a file.
std::vector<std::string> places_of(const SessionLibrary& reference, const std::string& session_path);

/// Checks that a library is the referenced one; the Error says how they differ.
Status check_session_library(const SessionLibrary& reference, const MotionLibrary& library);

}  // namespace abrazo
