#pragma once

#include <array>
#include <cstddef>

namespace abrazo::widgets {

/// What the scene can show or hide.
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
  LookAhead,   ///< where the partner goes next if the recording goes on
  Count
};

inline constexpr std::size_t scene_part_count = static_cast<std::size_t>(ScenePart::Count);
using PartVisibility = std::array<bool, scene_part_count>;
using PartCounts = std::array<int, scene_part_count>;

/// What is quiet until needed starts hidden.
inline constexpr PartVisibility default_visibility = [] {
  PartVisibility visible;
  visible.fill(true);
  for (const ScenePart quiet : {ScenePart::Tetrahedra, ScenePart::MorphSteps, ScenePart::Bones,
                                ScenePart::Touches, ScenePart::Trails})
    visible[static_cast<std::size_t>(quiet)] = false;
  return visible;
}();

}  // namespace abrazo::widgets
