#pragma once

#include <memory>

#include "core/base/result.hpp"
#include "core/stream/protocol/stream_encoder.hpp"

namespace abrazo {

/// @param body of the character, for bone offsets
Result<std::unique_ptr<StreamEncoder>> make_stream_encoder(const StreamUri& uri, const Body& body);

}  // namespace abrazo
