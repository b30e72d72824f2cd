#pragma once

#include <string>

#include "core/annotation/couple_geometry.hpp"
#include "core/annotation/move_model.hpp"

namespace abrazo {

/// Visible properties of a stretch as text: holds and hands on backs with their share of the stretch, turns
/// relative to the partner, change of places, distance, the fastest hand or foot. Empty if there are none.
std::string seen_geometry(const CoupleMotion& motion, const CoupleGeometry& geometry, int begin, int end);

/// "7 of 9 nearest labelled moves: turn".
std::string neighbour_words(const ProposedMove& move, const LabelledMoves& labelled);

/// Why a performer is considered active in an interval: whose movements come first, whose hand is on the
/// other's back, who strikes.
std::string role_words(const CoupleMotion& motion, const std::array<MotionChannels, 2>& channels, int begin,
                       int end, int active);

}  // namespace abrazo
