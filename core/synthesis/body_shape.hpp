#pragma once

#include <array>

#include "core/library/store/normalization.hpp"
#include "core/motion/body/body.hpp"

namespace abrazo {

/// A pose without its lengths and its place: the direction of every bone as seen from the body's own root
/// and heading, and the height of the root.
struct BodyShape {
  std::array<Vec3, bone_count> directions{};  ///< unit; zero for a bone of no length
  double root_height = 0;                     ///< above the floor [m]
};

/// @param own  relative to the body's root and heading
BodyShape shape_of(const Pose& own, double root_height);

/// Put together with these lengths, standing at `place`; its height does not count.
Pose placed_body(const BodyShape& shape, const Body& body, const RootFrame& place);

/// The rotation that turns one unit vector into another the short way, as a vector along its axis [rad].
Vec3 turn_between(const Vec3& from, const Vec3& to);
/// A vector turned so.
Vec3 turned(const Vec3& vector, const Vec3& turn);

}  // namespace abrazo
