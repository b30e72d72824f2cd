#pragma once

#include <cstdint>

namespace abrazo {

/// Memory available without swapping [bytes]: the kernel's estimate, including caches that it can drop. The
/// maximum value if unknown.
std::uint64_t available_memory_bytes();

}  // namespace abrazo
