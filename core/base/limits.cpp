#include "core/base/limits.hpp"

namespace abrazo {

const char* json_beyond_bounds(std::string_view json) {
  std::size_t depth = 0, values = 0;
  bool is_text = false;
  for (std::size_t at = 0; at < json.size(); ++at) {
    const char c = json[at];
    if (is_text) {
      if (c == '\\') ++at;
      if (c == '"') is_text = false;
      continue;
    }
    if (c == '"') is_text = true;
    const bool opens = c == '[' || c == '{';
    if (opens && ++depth > limits::json_depth)
      return "has brackets more than 100 deep inside each other; it is damaged";
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if ((opens || c == ',') && ++values > limits::json_values)
      return "has more than 6 million values; it is damaged, or is to be split";
  }
  return nullptr;
}

}  // namespace abrazo
