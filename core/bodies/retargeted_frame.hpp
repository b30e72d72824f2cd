#pragma once

#include <cstddef>

#include "core/bodies/pair_retargeting.hpp"
#include "core/synthesis/frames/frame_result.hpp"

namespace abrazo {

/// One frame of a retargeted pair as a solved frame, for traces and views: the recording becomes the
/// selected pair with its mesh, standing feet become foot locks. There are no candidates.
FrameResult frame_result_of(const RetargetedPair& pair, std::size_t frame);

}  // namespace abrazo
