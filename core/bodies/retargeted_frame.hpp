#pragma once

#include <cstddef>

#include "core/bodies/pair_retargeting.hpp"
#include "core/synthesis/frames/frame_result.hpp"

namespace abrazo {

/// One frame of a retargeted pair in the form of a solved one, for traces and views: the recording is the
/// selected pair, its mesh the mesh, standing feet are the locks. There are no candidates.
FrameResult frame_result_of(const RetargetedPair& pair, std::size_t frame);

}  // namespace abrazo
