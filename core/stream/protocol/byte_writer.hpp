#pragma once

#include <bit>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/positions.hpp"
#include "core/stream/protocol/byte_reader.hpp"

namespace abrazo {

/// Builds a packet field by field.
class ByteWriter {
 public:
  explicit ByteWriter(ByteOrder order) : order_(order) {}

  void u8(std::uint8_t value) { bytes_.push_back(value); }
  void u16(std::uint16_t value) { append(value, 2); }
  void u32(std::uint32_t value) { append(value, 4); }
  void i32(std::int32_t value) { u32(static_cast<std::uint32_t>(value)); }
  void u64(std::uint64_t value) { append(value, 8); }
  void f32(double value) { u32(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }
  void f64(double value) { u64(std::bit_cast<std::uint64_t>(value)); }
  void vec3(const Vec3& value) {
    for (int axis = 0; axis < 3; ++axis) f32(value[axis]);
  }
  void characters(std::string_view text) { bytes_.insert(bytes_.end(), text.begin(), text.end()); }
  /// Zero-terminated.
  void c_string(std::string_view text) {
    characters(text);
    u8(0);
  }
  void zeros(std::size_t number) { bytes_.insert(bytes_.end(), number, std::uint8_t{0}); }

  std::size_t size() const { return bytes_.size(); }
  /// Overwrites the value at `offset`, for sizes known only afterwards.
  void u32_at(std::size_t offset, std::uint32_t value) { overwrite(offset, value, 4); }

  const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  void append(std::uint64_t value, std::size_t size) {
    bytes_.resize(bytes_.size() + size);
    overwrite(bytes_.size() - size, value, size);
  }
  void overwrite(std::size_t offset, std::uint64_t value, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t shift = 8 * (order_ == ByteOrder::Big ? size - 1 - i : i);
      bytes_.at(offset + i) = static_cast<std::uint8_t>(value >> shift);
    }
  }

  ByteOrder order_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace abrazo
