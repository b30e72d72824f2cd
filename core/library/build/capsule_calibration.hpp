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

/// Capsule radii of each body, chosen so that recorded contact does not count as penetration. Starts from the
/// generic radii scaled by height / 1.75 m. If two bones i, j of a couple penetrate deeper than 1 cm in more
/// than 1 % of their frames (depth = r_i + r_j - distance), both radii shrink by the same factor until they
/// do not; the deepest pairs come first. A radius keeps at least 40 % of its initial value, so some pairs of
/// bones may stay above 1 cm. Hands and forearms are not compared with one another: holding hands must not
/// thin the arms. Reads at most about 3000 frames of each couple, evenly spread.
std::vector<CapsuleRadii> calibrate_capsules(std::span<const PairedTake> takes,
                                             std::span<const TakeBodies> take_bodies,
                                             std::span<const Body> bodies);

}  // namespace abrazo
