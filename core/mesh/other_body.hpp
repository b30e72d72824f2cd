#pragma once

#include <cstdint>

#include "core/mesh/interaction_mesh.hpp"

namespace abrazo {

/// The vertex of the same joint on the pair's other body.
constexpr std::uint8_t vertex_of_other_body(std::uint8_t vertex) {
  return static_cast<std::uint8_t>((vertex + joint_count) % pair_vertex_count);
}

}  // namespace abrazo
