#pragma once

#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Fills where a marker was not seen (NaN), as far as that is safe, and says in warnings how much and where:
/// - up to 0.2 s between two sightings: a cubic curve through both, with the speeds before and after;
/// - longer, or at the ends: carried by three markers that keep their distances to it (same segment);
/// - up to 0.5 s without such markers: the curve; at the ends up to 0.1 s: held;
/// - a marker that is never seen is removed.
/// What is longer stays NaN, so that a joint which needs it is refused.
void fill_gaps(NamedMotion& motion);

/// "RTOE is missing in frames 100 to 899" for each point of `points` that has gaps; empty when none has.
std::string gaps_of(const NamedMotion& motion, const std::vector<int>& points);

}  // namespace abrazo
