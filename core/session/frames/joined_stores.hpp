#pragma once

#include <memory>

#include "core/session/frames/frame_store.hpp"

namespace abrazo {

/// Two stores as one: up to where the later one begins, frames come from the earlier. Either may be null;
/// then it is the other.
std::shared_ptr<const FrameStore> joined_stores(std::shared_ptr<const FrameStore> earlier,
                                                std::shared_ptr<const FrameStore> later);

}  // namespace abrazo
