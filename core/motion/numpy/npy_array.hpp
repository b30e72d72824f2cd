#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo {

/// The header of a .npy file (numpy.org, "A simple file format for NumPy arrays", versions 1 to 3).
struct NpyLayout {
  enum class Kind { Real, Integer, Unsigned, Text, Bytes };
  Kind kind = Kind::Real;
  std::size_t item_bytes = 8;  ///< of one element
  bool big_endian = false;
  bool column_order = false;  ///< Fortran order: the first index runs fastest
  std::vector<std::uint64_t> shape;
  std::size_t header_bytes = 0;  ///< before the first element

  std::uint64_t count() const;  ///< number of elements; the maximum value on overflow
  std::uint64_t bytes() const;  ///< header and elements; the maximum value on overflow
  bool is_number() const { return kind != Kind::Text && kind != Kind::Bytes; }
  std::string shape_text() const;  ///< "(325, 51, 3)"
};

/// Bytes of a file sufficient for `parse_npy_header`.
inline constexpr std::size_t npy_header_most = 16384;

/// @param head  the beginning of a .npy file
/// @return an Error that says what was expected; Python objects (pickles) are refused here
Result<NpyLayout> parse_npy_header(std::string_view head, std::string_view where);

/// Elements of an array in memory. The bytes must outlive it.
class NpyArray {
 public:
  /// @param file  a .npy file, header and all: at least `layout.bytes()`
  NpyArray(NpyLayout layout, std::string_view file);

  const NpyLayout& layout() const { return layout_; }
  /// Element `index` in the order of memory.
  double number(std::uint64_t index) const;
  std::string text(std::uint64_t index) const;  ///< UTF-8, without trailing zeros
  /// Element (a, b, c) of three dimensions.
  double number(std::uint64_t a, std::uint64_t b, std::uint64_t c) const;

 private:
  std::uint64_t raw(std::size_t at, std::size_t bytes) const;

  NpyLayout layout_;
  std::string_view data_;
};

/// A .npy file of float64, C order, little-endian. @param shape  its product is the number of values
std::string npy_of_numbers(const std::vector<double>& values, const std::vector<std::uint64_t>& shape);
/// A .npy file of texts, or one text where there is no shape. @param texts  ASCII
std::string npy_of_texts(const std::vector<std::string>& texts, const std::vector<std::uint64_t>& shape);

}  // namespace abrazo
