#pragma once

#include <memory>

#include "core/base/result.hpp"
#include "core/stream/protocol/stream_decoder.hpp"
#include "core/stream/protocol/stream_uri.hpp"

namespace abrazo {

/// VMC protocol 2.x: Unity's humanoid bones over OSC, with local positions and rotations. Every sender
/// (address and port) is a performer. Points are the bones by their Unity names, and the ends of limbs as
/// "<bone>_End". See docs/guide/live/vmc.md.
/// @return an Error if an option is invalid
Result<std::unique_ptr<StreamDecoder>> make_vmc_decoder(const StreamUri& uri);

}  // namespace abrazo
