#pragma once

#include "widgets/scene/mesh_filter.hpp"
#include "widgets/scene/pointer_moves.hpp"

namespace abrazo::widgets {

/// How the scene shows what it shows; what is shown is `PartVisibility`.
struct SceneOptions {
  double shortest_m = 0, longest_m = MeshFilter::no_limit;  ///< of the edges that are shown
  bool picked_joint_only = false;                           ///< once a joint is picked, only what meets there
  double apart = 0;   ///< cells moved from the middle, share of their distance
  bool cuts = false;  ///< leave out what is nearer to the eye than a plane
  double cut_m = 0;   ///< how far before the middle of the pair that plane lies
  bool is_parallel = false;
  NavigationStyle navigation = NavigationStyle::Abrazo;
  bool operator==(const SceneOptions&) const = default;
};

}  // namespace abrazo::widgets
