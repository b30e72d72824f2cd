#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace abrazo {

struct GlbFile;

/// The numbers of an accessor of a GLB file, inside of its first buffer.
class GltfValues {
 public:
  /// @param index  of the accessor
  /// @param type   expected: SCALAR, VEC3, MAT4, ...
  /// @return none if the accessor is not there, of another type, sparse, or reaches beyond the buffer
  static std::optional<GltfValues> find(const GlbFile& glb, std::uint64_t index, std::string_view type);

  std::size_t size() const { return size_; }
  bool is_float() const;
  bool is_integer() const { return !is_float(); }
  /// A normalised integer as 0 to 1 (or -1 to 1), others as they are.
  double number(std::size_t value, std::size_t component) const;
  /// Of integer components.
  std::uint64_t integer(std::size_t value, std::size_t component) const;

 private:
  std::string_view bytes_;  ///< from the first value on
  std::size_t size_ = 0, stride_ = 0, component_bytes_ = 0;
  std::int64_t component_ = 0;
  bool is_normalized_ = false;
};

}  // namespace abrazo
