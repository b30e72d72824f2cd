#pragma once

#include <cstdlib>  // defines __GLIBC__
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace abrazo::app {

/// More than the window usually has threads: one that shares the heap of the window's thread can hold
/// the window up for as long as it has the lock of that heap.
constexpr int most_heaps = 24;

/// Has the C library return freed memory to the system. Left alone, glibc raises its limits with every large
/// block that is freed; after some sessions the heaps hold several times what is in use. Call before any
/// thread is started.
inline void return_freed_memory() {
#ifdef __GLIBC__
  ::mallopt(M_MMAP_THRESHOLD, 1 << 20);  // smaller ones cost pictures per second: new pages for each frame
  ::mallopt(M_TRIM_THRESHOLD, 16 << 20);
  ::mallopt(M_ARENA_MAX, most_heaps);
#endif
}

}  // namespace abrazo::app
