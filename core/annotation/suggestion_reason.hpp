#pragma once

#include <string>

#include "core/annotation/couple_geometry.hpp"
#include "core/annotation/move_model.hpp"

namespace abrazo {

/// What a person can see in a stretch of a take, in words: holds and hands on backs with the share of the
/// stretch, turns relative to the partner, places changed, being apart, the fastest hand or foot. Empty when
/// nothing of this is there.
std::string seen_geometry(const CoupleMotion& motion, const CoupleGeometry& geometry, int begin, int end);

/// "7 of 9 nearest labelled moves: turn".
std::string neighbour_words(const ProposedMove& move, const LabelledMoves& labelled);

/// Why a performer is considered active in an interval: whose movements come first, whose hand is on the
/// other's back, who strikes.
std::string role_words(const CoupleMotion& motion, const std::array<MotionChannels, 2>& channels, int begin,
                       int end, int active);

}  // namespace abrazo
