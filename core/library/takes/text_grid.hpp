#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/library/takes/tier_file.hpp"

namespace abrazo {

/// Tiers of a Praat TextGrid (the manual's page "TextGrid file formats"), long or short, in UTF-8 or UTF-16
/// as Praat writes it. Intervals without text are the gaps between others. Points have no length and are left
/// out, and counted.
/// @return an Error with the line, what was expected there and what was found
Result<TierDocument> parse_text_grid(std::string_view bytes, std::string_view where);

/// Interval tiers from 0 (or the first begin, if it is before) to the last end, in the long form. Times are
/// exact to the bit; kinds, vocabularies, detail and confidence have no place, nor have intervals without a
/// value.
TierText text_grid(std::span<const Tier> tiers);

}  // namespace abrazo
