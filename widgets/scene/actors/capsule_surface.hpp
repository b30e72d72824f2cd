#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/positions.hpp"
#include "core/mesh/capsules.hpp"

namespace abrazo::widgets {

/// Triangles of a body drawn as one capsule per bone. Topology is made once for a set of radii; a new pose
/// only moves points. Single precision, ready for the graphics card.
class CapsuleSurface {
 public:
  /// @param radii  per bone [m]; a bone of radius 0 is not drawn
  explicit CapsuleSurface(const CapsuleRadii& radii);

  /// @param girth        times every radius: of a body that is taller or shorter than the one of the radii
  /// @param inflation_m  added to every radius (for a silhouette)
  void place(const Pose& pose, double girth, double inflation_m, std::span<float> points) const;
  void place_normals(const Pose& pose, std::span<float> normals) const;

  int point_count() const { return static_cast<int>(bones_.size()) * points_per_capsule; }
  const std::vector<std::array<std::int64_t, 3>>& triangles() const { return triangles_; }
  /// Along the bone, 0 at one end to 1 at the other; for dashed outlines.
  const std::vector<float>& along() const { return along_; }

  static constexpr int segments = 12;
  static constexpr int cap_rings = 3;    ///< between pole and equator
  static constexpr int shaft_rings = 6;  ///< from equator to equator, both counted
  static constexpr int rings = 2 * cap_rings + shaft_rings;
  static constexpr int points_per_capsule = rings * segments + 2;

 private:
  struct BoneCapsule {
    int from, to;
    double radius;
  };
  template <typename Put>
  void visit(const Pose& pose, Put put) const;

  std::vector<BoneCapsule> bones_;
  std::vector<std::array<std::int64_t, 3>> triangles_;
  std::vector<float> along_;
};

}  // namespace abrazo::widgets
