#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace abrazo {

/// The member of an object of a file that may be damaged; null if there is none, or `value` is no object.
inline const nlohmann::json& member(const nlohmann::json& value, const char* key) {
  static const nlohmann::json nothing;
  if (!value.is_object()) return nothing;
  const auto found = value.find(key);
  return found == value.end() ? nothing : *found;
}

/// What a glTF file calls an element of a list: its number in version 2, its name in version 1. Null if there
/// is none.
inline const nlohmann::json& element(const nlohmann::json& list, const nlohmann::json& name) {
  static const nlohmann::json nothing;
  if (list.is_array() && name.is_number_unsigned() && name.get<std::size_t>() < list.size())
    return list[name.get<std::size_t>()];
  return list.is_object() && name.is_string() ? member(list, name.get<std::string>().c_str()) : nothing;
}

/// Types of the components of an accessor, as files number them.
namespace gltf {
inline constexpr std::int64_t signed_byte = 5120, unsigned_byte = 5121, signed_short = 5122,
                              unsigned_short = 5123, unsigned_int = 5125, single_float = 5126;

/// 0 for a type that the format does not have.
constexpr std::size_t bytes_of_component(std::int64_t component) {
  switch (component) {
    case signed_byte:
    case unsigned_byte:
      return 1;
    case signed_short:
    case unsigned_short:
      return 2;
    case unsigned_int:
    case single_float:
      return 4;
    default:
      return 0;
  }
}

/// Components of a value: SCALAR, VEC2, ...; 0 for another name.
constexpr std::size_t components_of(std::string_view type) {
  if (type == "SCALAR") return 1;
  for (const char side : {'2', '3', '4'}) {
    const auto n = static_cast<std::size_t>(side - '0');
    if (type.size() != 4 || type.back() != side) continue;
    if (type.starts_with("VEC")) return n;
    if (type.starts_with("MAT")) return n * n;
  }
  return 0;
}
}  // namespace gltf

}  // namespace abrazo
