#pragma once

#include "widgets/scene/values/cut_plane.hpp"
#include "widgets/scene/values/mesh_filter.hpp"
#include "widgets/scene/values/pointer_moves.hpp"

namespace abrazo::widgets {

/// Perceptual colour maps, safe for colour blindness; signed values have a separate map.
enum class ColourMap { Viridis, Cividis };

/// Display options of the scene; `PartVisibility` has the visible parts.
struct SceneOptions {
  double shortest_m = 0, longest_m = MeshFilter::no_limit;  ///< of the edges that are shown
  bool isolates = false;  ///< shows only items of the selection, if there is one
  double apart = 0;       ///< displacement of cells from the middle, share of their distance
  bool cuts = false;      ///< clips everything nearer to the eye than a plane
  double cut_m = 0;       ///< distance of that plane in front of the middle of the pair
  /// The plane is fixed in the world instead of the eye: through `cut_at`, moved by `cut_m` along its normal.
  bool cut_in_world = false;
  double cut_azimuth_rad = 0, cut_elevation_rad = 0;  ///< of the normal, which points to the clipped side
  Vec3 cut_at = Vec3(0, 1, 0);
  bool is_parallel = false;
  NavigationStyle navigation = NavigationStyle::Abrazo;
  ColourMap map = ColourMap::Viridis;
  bool is_logarithmic = false;  ///< two decades below the upper end, for unsigned values
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
