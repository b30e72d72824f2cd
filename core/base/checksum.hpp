#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace abrazo {

/// FNV-1a, 64 bits, byte by byte: detects corrupted bytes in session files.
class Checksum {
 public:
  void add(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) value_ = (value_ ^ byte) * 1099511628211ULL;
  }
  void add(std::string_view text) {
    for (const char c : text) value_ = (value_ ^ static_cast<std::uint8_t>(c)) * 1099511628211ULL;
  }
  void add(std::uint64_t number) { value_ = (value_ ^ number) * 1099511628211ULL, value_ ^= value_ >> 29; }
  std::int64_t value() const { return std::bit_cast<std::int64_t>(value_); }

 private:
  std::uint64_t value_ = 14695981039346656037ULL;
};

/// Mixes 64 bits at a time, 64 MiB in some 30 ms: distinguishes contents of files and libraries.
class ContentHash {
 public:
  void add(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x9e3779b97f4a7c15ULL;
    value_ ^= value_ >> 32;
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(std::string_view text) {
    add(std::uint64_t{text.size()});
    for (const char c : text) add(std::uint64_t{static_cast<unsigned char>(c)});
  }
  /// 16 hexadecimal digits.
  std::string text() const {
    static constexpr char digits[] = "0123456789abcdef";
    std::string hex;
    for (int shift = 60; shift >= 0; shift -= 4) hex += digits[(value_ >> shift) & 0xf];
    return hex;
  }

 private:
  std::uint64_t value_ = 0x6a09e667f3bcc908ULL;
};

}  // namespace abrazo
