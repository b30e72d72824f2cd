#pragma once

#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/takes/tier.hpp"
#include "core/library/takes/tier_file.hpp"
#include "core/session/export/session_export.hpp"

namespace abrazo {

/// The tiers of a session within a range; intervals are cut at its ends.
///   take            the takes by name
///   user role       active or passive, as the frames were solved
///   move followed label of the recorded frame that each solved frame followed, if it has one
///   take followed the library's take of that frame
///   meant the intended move, while it was in force
///   marker          1 ms each
/// and the tiers that a person annotated, with their kinds and vocabularies, without suggestions. Empty tiers
/// are left out, except the first three.
Result<std::vector<Tier>> session_tiers(const SessionRecord& session, const SessionRange& range);

/// Intervals cut to a range, without those outside.
std::vector<TierInterval> intervals_within(std::vector<TierInterval> intervals, double from_s, double to_s);

/// Moves as a label file (take,start_frame,end_frame,label,detail,confidence). Frames count from the first
/// frame of each take at the rate of that take's export, so both files match. The moves are the annotated
/// ones (first tier of moves), else those followed. Without takes the whole range is one take, named like the
/// session. The warnings count moves and annotated tiers that are left out.
/// @param rate_hz 0 = rate of the frames
Result<TierText> session_labels_csv(const SessionRecord& session, const SessionRange& range, double rate_hz);

}  // namespace abrazo
