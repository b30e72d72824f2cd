#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/library/takes/paired_take.hpp"

namespace abrazo {

/// Writes takes as BVH files in metres (`<take>_a.bvh`, `<take>_b.bvh`), `labels.csv` and `manifest.json`
/// into a folder (created if missing). The files appear together at the end; none after an error or
/// cancellation. The manifest has one letter for a take with a constant role, otherwise intervals.
/// @return path of the manifest
Result<std::filesystem::path> write_demo_set(const std::vector<PairedTake>& takes, const std::string& name,
                                             const std::filesystem::path& folder, const Progress& progress);

}  // namespace abrazo
