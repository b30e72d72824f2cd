#pragma once

#include <string>
#include <vector>

#include "core/library/takes/tier.hpp"
#include "core/session/file/session_database.hpp"

namespace abrazo {

/// What a file of version 1 noted in its table `intervals`: a tier for each kind, the moves as such, and
/// further tiers where intervals of a kind overlap. Roles are a tier of moves' neighbours only where they
/// are "a" and "b".
/// @param damage  of rows that cannot be, one sentence is added
std::vector<Tier> noted_intervals(SessionDatabase& database, std::vector<std::string>& damage);

}  // namespace abrazo
