#pragma once

#include <optional>
#include <string_view>

#include "core/library/takes/tier.hpp"

namespace abrazo {

/// "role", "move", "note".
std::string_view text_of(TierKind kind);
/// None for any other word.
std::optional<TierKind> parse_tier_kind(std::string_view text);

}  // namespace abrazo
