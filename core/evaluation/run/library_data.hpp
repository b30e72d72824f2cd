#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/evaluation/run/evaluate.hpp"
#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// As `read_evaluation_data` gives it for the manifest of this library: each take can be left out.
Result<EvaluationData> evaluation_data_of(std::shared_ptr<const MotionLibrary> library);

}  // namespace abrazo
