#pragma once

#include <memory>

#include "core/stream/protocol/stream_encoder.hpp"

namespace abrazo {

/// Xsens MVN network streaming: 23 segments as positions and quaternions (type 02), now and then the name
/// (12) and the scale (13). Options: "character=ID", "performer=NAME".
/// @return an Error for an option's value that is none
Result<std::unique_ptr<StreamEncoder>> make_xsens_encoder(const StreamUri& uri, const Body& body);

}  // namespace abrazo
