#pragma once

#include "widgets/scene/values/cut_plane.hpp"
#include "widgets/scene/values/mesh_filter.hpp"
#include "widgets/scene/values/pointer_moves.hpp"

namespace abrazo::widgets {

/// Perceptual maps that a colour-blind eye can read; signed values have a map of their own.
enum class ColourMap { Viridis, Cividis };

/// How the scene shows what it shows; what is shown is `PartVisibility`.
struct SceneOptions {
  double shortest_m = 0, longest_m = MeshFilter::no_limit;  ///< of the edges that are shown
  bool isolates = false;  ///< while something is selected, only what belongs to it
  double apart = 0;       ///< cells moved from the middle, share of their distance
  bool cuts = false;      ///< leave out what is nearer to the eye than a plane
  double cut_m = 0;       ///< how far before the middle of the pair that plane lies
  /// The plane stays in the world instead of with the eye: through `cut_at`, moved by `cut_m` along its
  /// normal.
  bool cut_in_world = false;
  double cut_azimuth_rad = 0, cut_elevation_rad = 0;  ///< of the normal; beyond it nothing is shown
  Vec3 cut_at = Vec3(0, 1, 0);
  bool is_parallel = false;
  NavigationStyle navigation = NavigationStyle::Abrazo;
  ColourMap map = ColourMap::Viridis;
  bool is_logarithmic = false;  ///< two decades below the upper end, where no value is signed
  double trail_s = 1.5;
  bool shows_reference_beside = false;

  bool operator==(const SceneOptions&) const = default;
  CutPlane plane() const {
    const Vec3 normal = direction_of(cut_azimuth_rad, cut_elevation_rad);
    return {cut_at + cut_m * normal, normal};
  }
  bool filters() const {
    return shortest_m > 0 || longest_m < MeshFilter::no_limit || isolates || apart > 0 || cuts;
  }
};

inline constexpr double shortest_trail_s = 0.25, longest_trail_s = 10;

}  // namespace abrazo::widgets
