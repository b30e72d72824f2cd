#pragma once

#include <cstdint>

namespace abrazo {

/// What programs may still take without others being moved out of memory [bytes]: the kernel's own estimate,
/// which counts caches that it can give up. The greatest number where it does not say.
std::uint64_t available_memory_bytes();

}  // namespace abrazo
