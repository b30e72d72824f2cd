#include "core/base/utf8.hpp"

namespace abrazo {

namespace {

/// Bytes of a character by its first; 0 when none begins so.
std::size_t length_of(unsigned char first) {
  if (first < 0x80) return 1;
  if (first < 0xC2) return 0;
  if (first < 0xE0) return 2;
  if (first < 0xF0) return 3;
  return first < 0xF5 ? 4 : 0;
}

/// Excludes overlong forms, surrogates, and values beyond U+10FFFF.
bool may_follow(unsigned char first, unsigned char second) {
  const unsigned char least = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const unsigned char greatest = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  return second >= least && second <= greatest;
}

}  // namespace

std::optional<std::size_t> first_broken_byte(std::string_view text) {
  const auto byte = [text](std::size_t at) { return static_cast<unsigned char>(text[at]); };
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = length_of(byte(at));
    if (length == 0 || at + length > text.size()) return at;
    if (length > 1 && !may_follow(byte(at), byte(at + 1))) return at;
    for (std::size_t i = 2; i < length; ++i)
      if ((byte(at + i) & 0xC0U) != 0x80) return at;
    at += length;
  }
  return std::nullopt;
}

}  // namespace abrazo
