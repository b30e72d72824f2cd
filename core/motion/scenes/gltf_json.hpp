#pragma once

#include <nlohmann/json.hpp>
#include <string>

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

}  // namespace abrazo
