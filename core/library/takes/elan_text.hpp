#pragma once

#include <string_view>

#include "core/base/result.hpp"
#include "core/library/takes/tier_file.hpp"

namespace abrazo {

/// Tiers out of ELAN's tab-delimited text (File > Export As): a line for each annotation, with or without a
/// line of titles. Times in hours:minutes:seconds, seconds or milliseconds, whichever were exported; begin
/// and end, or begin and duration, are needed. Annotations of one tier are put in the order of their begin.
Result<TierDocument> parse_elan_text(std::string_view text, std::string_view where);

}  // namespace abrazo
