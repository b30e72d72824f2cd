#pragma once

#include <cstdint>

namespace abrazo::test {

inline constexpr std::uint32_t this_machine = 0x7f000001;

/// A UDP port that nobody has.
std::uint16_t free_port();

/// A program has this UDP port open.
bool is_open(std::uint16_t port);

}  // namespace abrazo::test
