#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/library/takes/paired_take.hpp"
#include "core/mesh/capsules.hpp"
#include "core/motion/body/body.hpp"

namespace abrazo {

/// The bodies of a take's performers, as indices.
struct TakeBodies {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
};

/// Capsule radii of each body so that what was recorded counts as contact and not as penetration.
/// Starts from the generic radii scaled by height / 1.75 m. For every two bones i, j of two performers whose
/// capsules are deeper than 1 cm in one another in more than 1 % of the frames of this couple (depth = r_i +
/// r_j - distance), both radii shrink by the same factor until they are not; the deepest are treated first. A
/// radius keeps at least 40 % of its start, so a pair of bones can stay above 1 cm. Hand and forearm against
/// hand and forearm is left out: holding hands is no reason for thin arms. Reads at most about 3000 frames of
/// each couple, evenly spread.
std::vector<CapsuleRadii> calibrate_capsules(std::span<const PairedTake> takes,
                                             std::span<const TakeBodies> take_bodies,
                                             std::span<const Body> bodies);

}  // namespace abrazo
