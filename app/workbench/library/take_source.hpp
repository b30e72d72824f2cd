#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/library/takes/paired_take.hpp"

namespace abrazo::app {

/// Where recorded takes come from: an open library, or a manifest.
struct TakeSource {
  std::shared_ptr<const MotionLibrary> library;  ///< null with a manifest
  std::string name;                              ///< its file; of a library that was not saved its name

  bool operator==(const TakeSource&) const = default;
};

Result<std::vector<PairedTake>> read_takes(const TakeSource& source, const std::vector<std::string>& names,
                                           std::vector<std::string>& warnings, const Progress& progress);

}  // namespace abrazo::app
