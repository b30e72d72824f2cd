#pragma once

#include "core/motion/body/joint_set.hpp"
#include "core/synthesis/frames/frame_result.hpp"

namespace abrazo {

/// Room for the largest k (200), continuations (15) and a pinned pair.
inline constexpr std::size_t most_candidates = 256;
/// Morph, projection and extra projection steps of any setting: 20 + 10 + 8.
inline constexpr std::size_t most_edit_steps = 64;

/// Reserves memory for the largest frame, so that later frames do not allocate.
inline void reserve_room(FrameResult& frame) {
  constexpr std::size_t most_edges = pair_vertex_count * (pair_vertex_count - 1) / 2;
  constexpr std::size_t many_tetrahedra = 512;  // about 250 fill the hull of 50 joints
  constexpr std::size_t longest_message = 256;
  frame.candidates.reserve(most_candidates);
  frame.edges.reserve(most_edges);
  frame.edge_weights.reserve(most_edges);
  frame.edge_residuals_m.reserve(most_edges);
  frame.tetrahedra.reserve(many_tetrahedra);
  frame.morph_steps.reserve(most_edit_steps);
  frame.foot_locks.reserve(4);
  frame.holds.reserve(4);
  frame.collisions.reserve(static_cast<std::size_t>(bone_count) * bone_count);
  frame.message.reserve(longest_message);
}

}  // namespace abrazo
