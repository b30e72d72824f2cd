#pragma once

#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/library/takes/paired_take.hpp"

namespace abrazo {

/// The takes of a library, reconstructed from its pairs: both performers, world, at
/// the library's rate, with roles and labels. For a library whose files are not available.
/// An Error names a take with missing frames.
Result<std::vector<PairedTake>> takes_of_library(const MotionLibrary& library);

/// Those of these names, in their order. An Error lists the takes if one of them does not exist.
/// @param where  name of the library, for messages
Result<std::vector<PairedTake>> takes_of_library(const MotionLibrary& library,
                                                 const std::vector<std::string>& names,
                                                 const std::string& where);

/// The same takes of a manifest, read from their files at their own rate.
/// @param warnings  those of the manifest and of its files are appended
Result<std::vector<PairedTake>> takes_of_manifest(const std::string& file,
                                                  const std::vector<std::string>& names,
                                                  std::vector<std::string>& warnings,
                                                  const Progress& progress = {});

}  // namespace abrazo
