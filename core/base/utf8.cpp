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

void append(std::string& text, char32_t character) {
  const auto byte = [&](char32_t value) { text += static_cast<char>(value); };
  const auto follow = [&](int shift) { byte(0x80 | (character >> shift & 0x3F)); };
  if (character < 0x80) return byte(character);
  if (character < 0x800) return byte(0xC0 | character >> 6), follow(0);
  if (character < 0x10000) return byte(0xE0 | character >> 12), follow(6), follow(0);
  byte(0xF0 | character >> 18), follow(12), follow(6), follow(0);
}

/// Of UTF-16 without its mark (RFC 2781); none if a surrogate has no partner or half a unit is left over.
std::optional<std::string> from_utf16(std::string_view bytes, bool is_big_endian) {
  if (bytes.size() % 2 != 0) return std::nullopt;
  const auto unit = [&](std::size_t at) {
    const auto first = static_cast<unsigned char>(bytes[at]),
               second = static_cast<unsigned char>(bytes[at + 1]);
    return static_cast<char32_t>(is_big_endian ? first << 8 | second : second << 8 | first);
  };
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += 2) {
    const char32_t high = unit(at);
    if (high < 0xD800 || high > 0xDFFF) {
      append(text, high);
      continue;
    }
    at += 2;
    const char32_t low = at < bytes.size() ? unit(at) : 0;
    if (high > 0xDBFF || low < 0xDC00 || low > 0xDFFF) return std::nullopt;
    append(text, 0x10000 + ((high - 0xD800) << 10) + (low - 0xDC00));
  }
  return text;
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

std::optional<std::string> utf8_of(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE")) return from_utf16(bytes.substr(2), false);
  if (bytes.starts_with("\xFE\xFF")) return from_utf16(bytes.substr(2), true);
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  if (first_broken_byte(bytes)) return std::nullopt;
  return std::string(bytes);
}

}  // namespace abrazo
