#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/library/takes/tier.hpp"
#include "core/library/takes/tier_file.hpp"

namespace abrazo {

/// Whether a table begins with the header of tier,start,end,value.
bool is_tier_csv(std::string_view text);

/// Each form of table: tier,start,end,value in seconds, a label file in frames, or what ELAN exports.
Result<TierDocument> parse_tier_csv(std::string_view text, std::string_view where,
                                    const TierReading& reading);

/// tier,start,end,value,detail,confidence; times are exact to the bit.
TierText tier_csv(std::span<const Tier> tiers);

/// take,start_frame,end_frame,label,detail,confidence of the first tier of moves, or the only tier.
/// Times are rounded to the nearest frame; intervals that become empty and moves without a name are left out.
Result<TierText> label_csv(std::span<const Tier> tiers, std::string_view where, const TierWriting& writing);

/// Label track of Audacity: begin and end in seconds and the value, with tabs between, of the first tier of
/// moves, else the first with labels. Its name, all other tiers, detail and confidence have no place.
Result<TierText> audacity_labels(std::span<const Tier> tiers, std::string_view where);

}  // namespace abrazo
