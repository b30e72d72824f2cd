#pragma once

#include <span>
#include <string>
#include <vector>

#include "widgets/candidates/candidate_rows.hpp"

namespace abrazo::widgets {

/// Reason of the selection, from rows in order of cost. By Eq. 7: "Winner by 0.024 m² — less temporal cost of
/// the follower", the margin to the runner-up and the term that decided it. With `intent`: why the source
/// changed, "Change: continuing (#3) costs 0.060 m more — partner expected nearer", or why it did not,
/// "Continues: #2 costs 0.130 m more, 0.113 m of it for the change". Also states if the winner is not the
/// cheapest (a pinned pair), or has no competitor. Differences are those of the totals as rows show them, to
/// 0.001.
/// @param intent of the same frame
std::string winning_reason(const std::vector<CandidateRow>& rows, const FrameIntent& intent = {});

/// "Likely move: cross body 72 %, turn 20 %": the likeliest move, and a second if it is likely too. Empty if
/// unknown.
/// @param moves  P(label), one for each of `labels`
std::string likely_moves(std::span<const std::string> labels, std::span<const float> moves);

}  // namespace abrazo::widgets
