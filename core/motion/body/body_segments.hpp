#pragma once

#include <array>
#include <string_view>

#include "core/base/positions.hpp"

namespace abrazo {

/// Column of de Leva's (1996) table of segment masses and centres.
enum class SegmentTable { Male, Female, Mean };

inline constexpr int segment_count =
    14;  ///< head, trunk, and upper arm, forearm, hand, thigh, shank, foot twice

/// A rigid part of the body; its centre of mass lies between two ends. An end of the trunk is the middle of
/// two joints; elsewhere both joints are the same.
struct BodySegment {
  std::string_view name;
  double mass = 0;    ///< share of the body's mass
  double centre = 0;  ///< 0 = at `proximal`, 1 = at `distal`
  std::array<int, 2> proximal{}, distal{};
};

/// De Leva, "Adjustments to Zatsiorsky-Seluyanov's segment inertia parameters", J. Biomech. 29 (1996), table
/// 4, with the joints that replace her end points: the head end for the vertex, the thorax end for C7, the
/// ankle for the heel.
std::array<BodySegment, segment_count> body_segments(SegmentTable table);

/// Centre of mass of a segment in a pose [m].
Vec3 segment_centre(const BodySegment& segment, const Pose& pose);

/// Centre of mass of the whole body [m].
Vec3 centre_of_mass(const std::array<BodySegment, segment_count>& segments, const Pose& pose);

}  // namespace abrazo
