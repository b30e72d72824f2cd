#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// Index of the first body whose bones differ by less than 0.5 %; adds the body if there is none.
inline std::uint32_t find_or_add_body(std::vector<LibraryBody>& bodies, const Body& body,
                                      const std::string& name) {
  constexpr double same_body_difference = 0.005;  ///< of a bone's length
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (largest_length_difference(bodies[i].body, body) < same_body_difference)
      return static_cast<std::uint32_t>(i);
  bodies.push_back({name, body, {}});
  return static_cast<std::uint32_t>(bodies.size() - 1);
}

}  // namespace abrazo
