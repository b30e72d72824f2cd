#pragma once

#include <array>

#include "core/library/store/normalization.hpp"
#include "core/motion/body/body.hpp"

namespace abrazo {

/// A pose without bone lengths and place: the direction of every bone relative to the body's root and
/// heading, and the height of the root.
struct BodyShape {
  std::array<Vec3, bone_count> directions{};  ///< unit; zero for a bone of length 0
  double root_height = 0;                     ///< above the floor [m]
};

/// @param own  relative to the body's root and heading
BodyShape shape_of(const Pose& own, double root_height);

/// The pose with the lengths of `body`, standing at `place`; the height of `place` is ignored.
Pose placed_body(const BodyShape& shape, const Body& body, const RootFrame& place);

/// The smallest rotation from one unit vector to another, as a rotation vector [rad].
Vec3 turn_between(const Vec3& from, const Vec3& to);
/// A vector rotated by a rotation vector.
Vec3 turned(const Vec3& vector, const Vec3& turn);

}  // namespace abrazo
