#pragma once

#include <Eigen/Geometry>

#include "core/base/positions.hpp"

namespace abrazo {

/// Formulas for joint centres from skin markers [m].

/// Right-handed axes of the pelvis: x to the person's left, y up along it, z forward.
/// @param back  between the markers at the back
Eigen::Matrix3d pelvis_axes(const Vec3& left_front, const Vec3& right_front, const Vec3& back);

/// Hip joint centre by regression on the width between the front markers and the depth between their middle
/// and that of the back markers: Harrington et al., J. Biomech. 40 (2007) 595-602, adults and children
/// pooled, error about 7 mm.
/// @param side  +1 left, -1 right. @return in `pelvis_axes`, from the middle between the front markers
Vec3 hip_centre(double width_m, double depth_m, int side);

/// Joint centre at a known distance inside of the marker on its outer side: the directions to the joint above
/// and to the marker are perpendicular at it (the chord function of Davis et al., Hum. Mov. Sci. 10 (1991)
/// 575-587).
/// @param inward  from the marker into the limb; only its part across the limb counts
Vec3 chord_centre(const Vec3& joint_above, const Vec3& marker, const Vec3& inward, double distance_m);

/// Away from a marker on the outer side of a limb, across the line from `above` to `below`: of length 0 to 1,
/// shorter than 1 if the marker is nearer than 3 cm to the line and thus unreliable.
Vec3 away_from(const Vec3& outer_marker, const Vec3& above, const Vec3& below);

}  // namespace abrazo
