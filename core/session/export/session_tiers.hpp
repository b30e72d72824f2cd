#pragma once

#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/takes/tier.hpp"
#include "core/library/takes/tier_file.hpp"
#include "core/session/export/session_export.hpp"

namespace abrazo {

/// What a session says about its time, as tiers within a range; an interval that goes beyond ends there.
///   take            the takes by name
///   user role       active or passive, as the frames were solved
///   move followed   label of the recorded frame that each solved frame followed; none where it has none
///   take followed   the library's take that it is from
///   meant           what the person said that they mean, while it was in force
///   marker          1 ms each
/// and the tiers that a person annotated, with their kinds and vocabularies; nothing that is only suggested.
/// Tiers without an interval are left out, but for the first three.
Result<std::vector<Tier>> session_tiers(const SessionRecord& session, const SessionRange& range);

/// Cut to a range; what lies outside is left out.
std::vector<TierInterval> intervals_within(std::vector<TierInterval> intervals, double from_s, double to_s);

/// Moves as a label file (take,start_frame,end_frame,label,detail,confidence) whose frames count from the
/// first frame of each take, at the rate of an export of that take: the two belong together. Moves that were
/// annotated (first tier of moves), else those that were followed. Without takes the whole range is one,
/// named like the session. The warnings count the moves and the other annotated tiers that are not in it.
/// @param rate_hz  0 = that of the frames
Result<TierText> session_labels_csv(const SessionRecord& session, const SessionRange& range, double rate_hz);

}  // namespace abrazo
