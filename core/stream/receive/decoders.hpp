#pragma once

#include <memory>

#include "core/base/result.hpp"
#include "core/stream/protocol/stream_decoder.hpp"

namespace abrazo {

/// The decoder of a scheme; an Error for a clip.
Result<std::unique_ptr<StreamDecoder>> make_stream_decoder(const StreamUri& uri);

}  // namespace abrazo
