#include "core/base/json_nesting.hpp"

#include "core/base/text.hpp"

namespace abrazo {

bool nests_too_deep(std::string_view json) {
  constexpr std::size_t deepest = 100;
  return nesting_depth(json) > deepest;
}

}  // namespace abrazo
