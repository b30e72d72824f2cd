#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "widgets/scene/values/cut_plane.hpp"
#include "widgets/scene/values/mesh_filter.hpp"
#include "widgets/scene/values/pointer_moves.hpp"

namespace abrazo::widgets {

/// Perceptual colour maps, safe for colour blindness; signed values have a separate map.
enum class ColourMap { Viridis, Cividis };

/// Display options of the scene; `PartVisibility` has the visible parts.
struct SceneOptions {
  double shortest_m = 0, longest_m = MeshFilter::no_limit;    ///< of the edges that are shown
  double least_value = 0, most_value = MeshFilter::no_limit;  ///< of their value, see MeshFilter
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
  /// Characters of other programs (GLB, VRM) that are wanted as skins, active then passive; empty = capsules.
  std::array<std::string, 2> character_files;

  bool operator==(const SceneOptions&) const = default;
  CutPlane plane() const {
    const Vec3 normal = direction_of(cut_azimuth_rad, cut_elevation_rad);
    return {cut_at + cut_m * normal, normal};
  }
  bool has_cut_of(const SceneOptions& o) const {
    return cuts == o.cuts && cut_m == o.cut_m && cut_in_world == o.cut_in_world &&
           cut_azimuth_rad == o.cut_azimuth_rad && cut_elevation_rad == o.cut_elevation_rad &&
           cut_at == o.cut_at;
  }
  void take_cut_of(const SceneOptions& o) {
    cuts = o.cuts;
    cut_m = o.cut_m;
    cut_in_world = o.cut_in_world;
    cut_azimuth_rad = o.cut_azimuth_rad;
    cut_elevation_rad = o.cut_elevation_rad;
    cut_at = o.cut_at;
  }
  /// Turns the plane about its present point.
  void turn_cut_to(const Vec3& normal) {
    const Vec3 point = plane().point;
    if (std::hypot(normal.x(), normal.z()) > 1e-6) cut_azimuth_rad = std::atan2(normal.x(), normal.z());
    cut_elevation_rad = std::asin(std::clamp(normal.y(), -1.0, 1.0));
    cut_at = point - cut_m * direction_of(cut_azimuth_rad, cut_elevation_rad);
  }
  bool filters() const { return filters_edges() || isolates || apart > 0 || cuts; }
  bool filters_edges() const {
    return shortest_m > 0 || longest_m < MeshFilter::no_limit || least_value > 0 ||
           most_value < MeshFilter::no_limit;
  }
};

inline constexpr double shortest_trail_s = 0.25, longest_trail_s = 10;

}  // namespace abrazo::widgets
