#pragma once

#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Fills gaps of markers (NaN) where that is safe, and reports them as warnings:
/// - up to 0.2 s between two sightings: a cubic curve through both, with the velocities before and after;
/// - longer, or at the ends: rigid motion of three markers at constant distances to it (same segment);
/// - up to 0.5 s without such markers: the curve; at the ends up to 0.1 s: held;
/// - a marker that is never seen is removed. Longer gaps stay NaN, so that a joint that needs the marker is
/// refused.
void fill_gaps(NamedMotion& motion);

/// "RTOE is missing in frames 100 to 899" for each point of `points` with gaps; empty if there are none.
std::string gaps_of(const NamedMotion& motion, const std::vector<int>& points);

}  // namespace abrazo
