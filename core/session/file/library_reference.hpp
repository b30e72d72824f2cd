#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/session/file/session_file.hpp"

namespace abrazo {

/// Two numbers of 16 hexadecimal digits, with a space between: the first over everything that affects results
/// (takes with their labels, pairs, poses, meshes, bodies), the second over the same without what was said of
/// the takes (labels, and which roles are annotated), as long as that changed no pair.
std::string library_fingerprint(const MotionLibrary& library);
/// Whether two fingerprints are of libraries with the same pairs, poses and meshes, whatever their labels.
bool is_same_motion(std::string_view fingerprint, std::string_view other);
/// A recording that was cut off may have no fingerprint: then the number of pairs is compared.
bool is_comparable(std::string_view fingerprint);

/// Paths at which to look for a session's library: relative to the session file, then the absolute path at
/// recording. Empty for a library that was never a file.
std::vector<std::string> places_of(const SessionLibrary& reference, const std::string& session_path);

/// Checks that a library is the referenced one; the Error says how they differ.
Status check_session_library(const SessionLibrary& reference, const MotionLibrary& library);
/// Whether frames that were solved with the referenced library can be shown with this one: it has the same
/// pairs and meshes.
bool has_motion_of(const SessionLibrary& reference, const MotionLibrary& library);

}  // namespace abrazo
