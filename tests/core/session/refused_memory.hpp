#pragma once

#include <cstddef>

namespace abrazo::test {

/// From now on whoever asks for so many bytes at once, on any thread, does not get them.
void refuse_memory(std::size_t bytes);
/// From now on whoever asks for so many bytes at once waits for them.
void hold_back_memory(std::size_t bytes);
void give_memory_again();

}  // namespace abrazo::test
