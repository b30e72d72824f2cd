#pragma once

#include <memory>

#include "core/stream/protocol/stream_decoder.hpp"

namespace abrazo {

/// Xsens MVN network streaming, MXTP (docs/guide/live/xsens.md): poses as positions and quaternions (02), as
/// positions and Euler angles (01) or for Unity (05); names (12), scale (13) and time code (25). One
/// performer per character id. Option "units=m|cm"; without it the unit is detected from the length of the
/// trunk.
/// @return an Error for an invalid option value
Result<std::unique_ptr<StreamDecoder>> make_xsens_decoder(const StreamUri& uri);

}  // namespace abrazo
