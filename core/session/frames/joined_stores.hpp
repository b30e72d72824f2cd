#pragma once

#include <memory>

#include "core/session/frames/frame_store.hpp"

namespace abrazo {

/// Two stores as one: frames before the begin of the later store come from the earlier. If one is null,
/// returns the other.
std::shared_ptr<const FrameStore> joined_stores(std::shared_ptr<const FrameStore> earlier,
                                                std::shared_ptr<const FrameStore> later);

}  // namespace abrazo
