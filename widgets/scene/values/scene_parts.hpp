#pragma once

#include <array>
#include <cstddef>

namespace abrazo::widgets {

/// The parts that the scene can show or hide.
enum class ScenePart {
  User,
  Leader,
  Follower,
  SelectedPair,
  MeshBetween,
  MeshWithin,
  Tetrahedra,
  MorphSteps,
  Bones,
  Joints,
  FootLocks,
  Contacts,  ///< limbs that overlap
  Touches,   ///< hands that hold one another, feet on the floor
  Trails,
  Floor,
  Comparison,  ///< bodies of another run
  LookAhead,   ///< the partner's next poses if the recording continues
  Count
};

inline constexpr std::size_t scene_part_count = static_cast<std::size_t>(ScenePart::Count);
using PartVisibility = std::array<bool, scene_part_count>;
using PartCounts = std::array<int, scene_part_count>;

/// Rarely needed parts are hidden initially.
inline constexpr PartVisibility default_visibility = [] {
  PartVisibility visible;
  visible.fill(true);
  for (const ScenePart quiet : {ScenePart::Tetrahedra, ScenePart::MorphSteps, ScenePart::Bones,
                                ScenePart::Touches, ScenePart::Trails})
    visible[static_cast<std::size_t>(quiet)] = false;
  return visible;
}();

}  // namespace abrazo::widgets
