#include "tests/core/session/refused_memory.hpp"

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <new>
#include <thread>

namespace {

constexpr auto none = static_cast<std::size_t>(-1);
std::atomic<std::size_t> refused_bytes = none, held_bytes = none;

}  // namespace

namespace abrazo::test {

void refuse_memory(std::size_t bytes) {
  refused_bytes = bytes;
}

void hold_back_memory(std::size_t bytes) {
  held_bytes = bytes;
}

void give_memory_again() {
  refused_bytes = none;
  held_bytes = none;
}

}  // namespace abrazo::test

// NOLINTBEGIN(cppcoreguidelines-no-malloc)
void* operator new(std::size_t size) {
  while (size >= held_bytes) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  void* const memory = size < refused_bytes ? std::malloc(size) : nullptr;
  if (!memory) throw std::bad_alloc();
  return memory;
}

void operator delete(void* memory) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
// NOLINTEND(cppcoreguidelines-no-malloc)
