#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/evaluation/run/evaluate.hpp"
#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// The takes of a library, reconstructed from its pairs: both performers, world, at
/// the library's rate, with roles and labels. For evaluations of a library whose files are not available.
/// An Error names a take with missing frames.
Result<std::vector<PairedTake>> takes_of_library(const MotionLibrary& library);

/// As `read_evaluation_data` gives it for the manifest of this library: each take can be left out.
Result<EvaluationData> evaluation_data_of(std::shared_ptr<const MotionLibrary> library);

}  // namespace abrazo
