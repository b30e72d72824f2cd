#pragma once

namespace abrazo {

// How far a part reaches, in lengths of the part before, as in an average adult.
inline constexpr double toe_tip_beyond_foot = 1.35;
inline constexpr double hand_beyond_forearm = 1.28;

}  // namespace abrazo
