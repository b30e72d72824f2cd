#pragma once

#include <memory>

#include "core/stream/protocol/stream_encoder.hpp"

namespace abrazo {

/// The server's side of NatNet: one skeleton in Motive's naming. Answers those who ask (CONNECT, MODELDEF,
/// echo, keep-alive); frames go to them. Options: "version=3.0|3.1|4.0|4.1", "performer=NAME" of the
/// skeleton.
/// @return an Error for an option's value that is none
Result<std::unique_ptr<StreamEncoder>> make_natnet_encoder(const StreamUri& uri, const Body& body);

}  // namespace abrazo
