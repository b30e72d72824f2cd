#pragma once

#include <memory>
#include <string>

#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/session/file/session_file.hpp"

namespace abrazo {

/// 16 hexadecimal digits that differ when a library gives other results: takes, pairs, poses, meshes, bodies.
std::string library_fingerprint(const MotionLibrary& library);

/// Opens the library that a session was solved with: beside the session file, then where it was when
/// recorded. The error says where it was looked for, or that it has changed since.
Result<std::shared_ptr<const MotionLibrary>> open_session_library(const SessionLibrary& reference,
                                                                  const std::string& session_path);

/// Whether a library is the one that is meant; the error says how they differ.
Status check_session_library(const SessionLibrary& reference, const MotionLibrary& library);

}  // namespace abrazo
