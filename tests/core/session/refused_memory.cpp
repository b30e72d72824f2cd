#include "tests/core/session/refused_memory.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

constexpr auto none = static_cast<std::size_t>(-1);
std::atomic<std::size_t> refused_bytes = none;

}  // namespace

namespace abrazo::test {

void refuse_memory(std::size_t bytes) {
  refused_bytes = bytes;
}

void give_memory_again() {
  refused_bytes = none;
}

}  // namespace abrazo::test

// NOLINTBEGIN(cppcoreguidelines-no-malloc)
void* operator new(std::size_t size) {
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
