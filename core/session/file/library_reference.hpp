#pragma once

#include <memory>
#include <string>

#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/session/file/session_file.hpp"

namespace abrazo {

/// 16 hexadecimal digits that differ when a library gives other results: takes, pairs, poses, meshes, bodies.
std::string library_fingerprint(const MotionLibrary& library);

/// Where the library of a session may be: beside the session file, then where it was when recorded. Empty for
/// one that was never a file.
std::vector<std::string> places_of(const SessionLibrary& reference, const std::string& session_path);

/// Whether a library is the one that is meant; the error says how they differ.
Status check_session_library(const SessionLibrary& reference, const MotionLibrary& library);

}  // namespace abrazo
