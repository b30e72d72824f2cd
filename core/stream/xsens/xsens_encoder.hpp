#pragma once

#include <memory>

#include "core/stream/protocol/stream_encoder.hpp"

namespace abrazo {

/// Xsens MVN network streaming: 23 segments as positions and quaternions (type 02), and at intervals the name
/// (12) and the scale (13). Options: "character=ID", "performer=NAME".
/// @return an Error for an invalid option value
Result<std::unique_ptr<StreamEncoder>> make_xsens_encoder(const StreamUri& uri, const Body& body);

}  // namespace abrazo
