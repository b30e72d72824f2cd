#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/base/positions.hpp"

namespace abrazo {

enum class ByteOrder { Little, Big };

/// Reads a packet's fields in sequence, never beyond its end. It fails at the first field that does not fit;
/// later reads return 0 or empty, so a parser may check once at its end. Every field has a name for messages.
class ByteReader {
 public:
  /// @param origin offset of the first byte in the packet, for messages
  ByteReader(std::span<const std::uint8_t> bytes, ByteOrder order, std::size_t origin = 0)
      : bytes_(bytes), order_(order), origin_(origin) {}

  std::uint8_t u8(std::string_view what) { return static_cast<std::uint8_t>(integer(1, what)); }
  std::uint16_t u16(std::string_view what) { return static_cast<std::uint16_t>(integer(2, what)); }
  std::uint32_t u32(std::string_view what) { return static_cast<std::uint32_t>(integer(4, what)); }
  std::int32_t i32(std::string_view what) { return static_cast<std::int32_t>(u32(what)); }
  std::uint64_t u64(std::string_view what) { return integer(8, what); }
  float f32(std::string_view what) { return std::bit_cast<float>(u32(what)); }
  double f64(std::string_view what) { return std::bit_cast<double>(u64(what)); }
  /// Three floats.
  Vec3 vec3(std::string_view what);

  /// Number of following elements (i32) of at least `least_bytes` (>= 1) each. Fails if they cannot fit, so
  /// that no memory is reserved for them.
  std::size_t count(std::string_view what, std::size_t least_bytes);
  /// Characters up to a zero byte, which is consumed.
  std::string c_string(std::string_view what);
  std::string characters(std::size_t length, std::string_view what);
  void skip(std::size_t length, std::string_view what);
  /// A reader of the next `length` bytes only; this one continues after them.
  ByteReader part(std::size_t length, std::string_view what);

  std::size_t left() const { return failed() ? 0 : bytes_.size() - at_; }
  std::size_t offset() const { return origin_ + at_; }
  bool failed() const { return !failure_.empty(); }
  /// "at byte 210: expected the position of a bone (12 bytes), but 3 are left"; empty without a failure.
  const std::string& failure() const { return failure_; }
  /// Reports an invalid value. Only the first failure is kept.
  void fail(std::string_view why);

 private:
  std::uint64_t integer(std::size_t size, std::string_view what);
  bool has(std::size_t length, std::string_view what);

  std::span<const std::uint8_t> bytes_;
  ByteOrder order_;
  std::size_t origin_;
  std::size_t at_ = 0;
  std::string failure_;
};

}  // namespace abrazo
