#pragma once

#include <memory>

#include "core/stream/protocol/stream_encoder.hpp"

namespace abrazo {

/// The server side of NatNet: one skeleton in Motive's naming. Answers clients (CONNECT, MODELDEF, echo,
/// keep-alive) and sends frames to them. Options: "version=3.0|3.1|4.0|4.1", "performer=NAME" of the
/// skeleton.
/// @return an Error for an invalid option value
Result<std::unique_ptr<StreamEncoder>> make_natnet_encoder(const StreamUri& uri, const Body& body);

}  // namespace abrazo
