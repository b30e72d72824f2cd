#pragma once

#include <Eigen/Core>
#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace abrazo {

/// Writes numbers in sequence, little-endian.
class BlobWriter {
 public:
  template <typename Unsigned>
  void number(Unsigned value) {
    for (std::size_t i = 0; i < sizeof(Unsigned); ++i)
      bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  void byte(std::uint8_t value) { bytes_.push_back(value); }
  void flag(bool value) { byte(value ? 1 : 0); }
  void integer(std::int64_t value) { number(std::bit_cast<std::uint64_t>(value)); }
  void small_integer(std::int32_t value) { number(std::bit_cast<std::uint32_t>(value)); }
  void real(double value) { number(std::bit_cast<std::uint64_t>(value)); }
  void text(std::string_view value) {
    number(static_cast<std::uint32_t>(value.size()));
    bytes_.insert(bytes_.end(), value.begin(), value.end());
  }
  /// Writes a matrix row by row.
  template <typename Derived>
  void matrix(const Eigen::MatrixBase<Derived>& values) {
    for (Eigen::Index r = 0; r < values.rows(); ++r)
      for (Eigen::Index c = 0; c < values.cols(); ++c) real(values(r, c));
  }
  template <typename Numbers>
  void reals(const Numbers& values) {
    for (const double value : values) real(value);
  }

  void reserve(std::size_t bytes) { bytes_.reserve(bytes); }
  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// Reads numbers written by BlobWriter. Past the end every number is zero and `is_done` is false.
class BlobReader {
 public:
  explicit BlobReader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  template <typename Unsigned>
  Unsigned number() {
    Unsigned value = 0;
    if (!has(sizeof(Unsigned))) return value;
    for (std::size_t i = 0; i < sizeof(Unsigned); ++i)
      value = static_cast<Unsigned>(value | (static_cast<Unsigned>(rest_[i]) << (8 * i)));
    rest_ = rest_.subspan(sizeof(Unsigned));
    return value;
  }
  std::uint8_t byte() { return number<std::uint8_t>(); }
  bool flag() { return byte() != 0; }
  std::int64_t integer() { return std::bit_cast<std::int64_t>(number<std::uint64_t>()); }
  std::int32_t small_integer() { return std::bit_cast<std::int32_t>(number<std::uint32_t>()); }
  double real() { return std::bit_cast<double>(number<std::uint64_t>()); }
  std::string text() {
    const std::uint32_t size = number<std::uint32_t>();
    if (!has(size)) return {};
    std::string value(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(size));
    rest_ = rest_.subspan(size);
    return value;
  }
  template <typename Derived>
  void matrix(Eigen::MatrixBase<Derived>& values) {
    for (Eigen::Index r = 0; r < values.rows(); ++r)
      for (Eigen::Index c = 0; c < values.cols(); ++c) values(r, c) = real();
  }
  template <typename Numbers>
  void reals(Numbers& values) {
    for (double& value : values) value = real();
  }

  std::size_t left() const { return rest_.size(); }
  bool is_done() const { return good_ && rest_.empty(); }  ///< all bytes read, none missing

 private:
  bool has(std::size_t bytes) {
    if (rest_.size() >= bytes) return true;
    good_ = false;
    rest_ = {};
    return false;
  }
  std::span<const std::uint8_t> rest_;
  bool good_ = true;
};

}  // namespace abrazo
