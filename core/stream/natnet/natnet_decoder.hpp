#pragma once

#include <memory>

#include "core/stream/protocol/stream_decoder.hpp"

namespace abrazo {

/// NatNet 3.0 to 4.2, as OptiTrack Motive sends it (docs/guide/live/natnet.md): requests version
/// and model from the host, keeps the connection alive, and decodes the skeletons' bones in world
/// coordinates. Options: "multicast=GROUP", "coordinates=global|local", "up=y|z"; without the last two they
/// are detected from the data and reported in `facts`.
/// @return an Error for an invalid option value
Result<std::unique_ptr<StreamDecoder>> make_natnet_decoder(const StreamUri& uri);

}  // namespace abrazo
