#pragma once

#include <cstdlib>  // defines __GLIBC__
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace abrazo::app {

/// Has the C library return freed memory to the system. Left alone, glibc raises its limits with every large
/// block that is freed and gives each thread a heap of its own; after some sessions these hold several times
/// what is in use. Call before any thread is started.
inline void return_freed_memory() {
#ifdef __GLIBC__
  ::mallopt(M_MMAP_THRESHOLD, 1 << 20);  // smaller ones cost pictures per second: new pages for each frame
  ::mallopt(M_TRIM_THRESHOLD, 16 << 20);
  ::mallopt(M_ARENA_MAX, 2);
#endif
}

}  // namespace abrazo::app
