#pragma once

#include <string>
#include <vector>

#include "core/library/takes/tier.hpp"
#include "core/session/file/session_database.hpp"

namespace abrazo {

/// The table `intervals` of a version 1 file as tiers: one per kind, and further ones where intervals of a
/// kind overlap. Moves become a tier of moves; roles become a tier of roles only if they are "a" and "b".
/// @param damage gets one sentence about invalid rows
std::vector<Tier> noted_intervals(SessionDatabase& database, std::vector<std::string>& damage);

}  // namespace abrazo
