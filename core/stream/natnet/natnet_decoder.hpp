#pragma once

#include <memory>

#include "core/stream/protocol/stream_decoder.hpp"

namespace abrazo {

/// NatNet 3.0 to 4.1 and later, as OptiTrack Motive sends it (docs/guide/live/natnet.md): asks the host for
/// its version and the model, keeps the connection alive, gives the skeletons' bones in world coordinates.
/// Options: "multicast=GROUP", "coordinates=global|local", "up=y|z"; without the last two they are found from
/// the data and said in `facts`.
/// @return an Error for an option's value that is none
Result<std::unique_ptr<StreamDecoder>> make_natnet_decoder(const StreamUri& uri);

}  // namespace abrazo
