#pragma once

namespace abrazo {

// Extent of a part in lengths of the previous part, for an average adult.
inline constexpr double toe_tip_beyond_foot = 1.35;
inline constexpr double hand_beyond_forearm = 1.28;

}  // namespace abrazo
