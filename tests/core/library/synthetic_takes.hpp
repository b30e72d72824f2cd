#pragma once

#include <string>

#include "core/library/takes/paired_take.hpp"

namespace abrazo::test {

/// Two people who circle about one another at `distance_m`, turning and stepping a little, as rigid bodies;
/// 60 frames per second. Equal arguments give equal takes.
PairedTake circling_take(const std::string& name, int frames, double distance_m = 0.8, unsigned seed = 1);

}  // namespace abrazo::test
