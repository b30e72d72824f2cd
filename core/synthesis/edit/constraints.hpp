#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/positions.hpp"
#include "core/motion/body/body.hpp"

namespace abrazo {

enum class RowKind : std::uint8_t { Bone, FootLock, Floor, Capsule };

/// One hard constraint, linear at the current iterate: direction . sum_i weight_i v_(vertex_i) = target (>=
/// for an inequality). All coefficients share one direction, which makes the solver fast.
struct ConstraintRow {
  RowKind kind = RowKind::Bone;
  bool inequality = false;
  int count = 0;  ///< number of vertices used
  std::array<int, 4> vertices{};
  std::array<double, 4> weights{};
  Vec3 direction = Vec3::Zero();
  double target = 0;  ///< [m]

  double value(const PairPose& positions) const;
  /// Coefficient of vertex `vertices[i]`.
  Vec3 coefficient(int i) const { return weights[static_cast<std::size_t>(i)] * direction; }
};

/// Two vertices that keep their distance: bones, and the pseudo-bones of pelvis and shoulder girdle.
struct RigidDistance {
  int a = 0;
  int b = 0;
  double length_m = 0;
};
inline constexpr int rigid_distance_count = 2 * (bone_count + static_cast<int>(pseudo_bones.size()));
using RigidDistances = std::array<RigidDistance, rigid_distance_count>;

/// The rigid distances of a pair, with their lengths in this pose.
RigidDistances rigid_distances(const PairPose& pose);

/// Bone rows u . (v_a - v_b) = l with u = (v_a - v_b)/|v_a - v_b| at `iterate`; a bone of length 0 takes its
/// direction from `reference`. One row per entry of `lengths`, in their order.
void add_bone_rows(const PairPose& iterate, const PairPose& reference, const RigidDistances& lengths,
                   std::vector<ConstraintRow>& rows);

/// Largest |length - wanted| / wanted over bones (pseudo-bones left out).
double bone_length_error(const PairPose& positions, const RigidDistances& lengths);

/// The ankles, toe bases and toe tips of both bodies stay above the floor: y >= min(`lowest`, height in the
/// reference).
void add_floor_rows(const PairPose& reference, double lowest_m, std::vector<ConstraintRow>& rows);

/// Fixes a vertex at a position (three rows).
void add_position_rows(int vertex, const Vec3& position, std::vector<ConstraintRow>& rows);

/// Fixes x and z of a vertex (two rows).
void add_place_rows(int vertex, const Vec3& position, std::vector<ConstraintRow>& rows);

}  // namespace abrazo
