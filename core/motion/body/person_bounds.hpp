#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/positions.hpp"

namespace abrazo {

/// Bounds of what can be a person's pose. They are wide on purpose: they tell a person of any size, an avatar
/// of any shape and a capture with its usual errors from what is neither. The salsa captures of CMU, two
/// avatars and generated dancers keep to less than half of each.
namespace person_bounds {

/// Of any coordinate [m]: no place of capture is larger.
inline constexpr double farthest_m = 1e4;
/// The root above or below the floor [m]: an artist on a rope is below it.
inline constexpr double highest_root_m = 10;
/// Of any bone [m]. The thighs of the tallest man known (2.72 m) were some 0.75 m long; giants of games have
/// twice that.
inline constexpr double longest_bone_m = 2;
/// All 24 bones together [m]: 4.2 m of an adult, 1.2 m of a newborn.
inline constexpr double shortest_bones_m = 0.5;
/// Thighs and shins of all bones: 0.36 to 0.47 of people and avatars; 4/24 when all bones are alike, as
/// between points at random.
inline constexpr double least_leg_share = 0.22;
/// A thigh, shin, upper arm or forearm to that of the other side, 1.07 in the captures, and the difference
/// that counts at least [m]: joints that jitter by 3 cm never reach both, by 5 cm in one frame of thirty.
inline constexpr double most_uneven = 2.5, least_uneven_m = 0.15;
/// Of the joints' mean [m/s], and how far they then go at least [m]. Sprinters reach 12 m/s, the worst error
/// of the captures 9 m/s.
inline constexpr double fastest_m_per_s = 20;
inline constexpr double least_jump_m = 0.1;

}  // namespace person_bounds

/// A sentence that needs no memory: a step allocates none.
struct PersonDoubt {
  std::array<char, 160> text{};
  std::string_view sentence() const { return text.data(); }
};

/// Why a pose is no person's: "lfemur is 45.20 m long; no bone of a person is longer than 2 m". Nothing when
/// it can be one. @param pose  world space [m], Y up, floor near y = 0; need not be finite
std::optional<PersonDoubt> why_not_a_person(const Pose& pose);

/// Whether no person moves like this. @param elapsed_s  above 0
bool is_jump_of_nobody(const Pose& from, const Pose& to, double elapsed_s);

/// What of a clip cannot be a person's, counted over its frames.
struct PersonDoubts {
  std::size_t poses = 0, jumps = 0;
  std::size_t first_pose = 0, first_jump = 0;  ///< frames; where there is one
  std::string first_reason;                    ///< of the first pose that is no person's
};
PersonDoubts person_doubts(std::span<const Pose> poses, double fps);

}  // namespace abrazo
