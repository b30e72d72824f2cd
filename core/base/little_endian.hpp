#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace abrazo {

/// The number in `count` bytes from `at` on, the lowest first. The bytes must exist.
inline std::uint64_t little_endian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

}  // namespace abrazo
