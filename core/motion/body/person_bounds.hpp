#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/positions.hpp"

namespace abrazo {

/// Bounds for a person's pose. They are wide on purpose: they accept persons of any size, avatars of any
/// shape and captures with usual errors. The salsa captures of CMU, two avatars and generated dancers stay
/// below half of each.
namespace person_bounds {

/// Any coordinate [m]: no capture volume is larger.
inline constexpr double farthest_m = 1e4;
/// Root above or below the floor [m]: an aerial artist may be below it.
inline constexpr double highest_root_m = 10;
/// Any bone [m]. The thighs of the tallest known man (2.72 m) were about 0.75 m long; giants in games have
/// twice that.
inline constexpr double longest_bone_m = 2;
/// Sum of all 24 bones [m]: 4.2 m for an adult, 1.2 m for a newborn.
inline constexpr double shortest_bones_m = 0.5;
/// Share of thighs and shins in the sum of all bones: 0.36 to 0.47 for people and avatars; 4/24 for random
/// points, where all bones are similar.
inline constexpr double least_leg_share = 0.22;
/// Ratio of a thigh, shin, upper arm or forearm to the other side (1.07 in the captures), and the smallest
/// difference that counts [m]: jitter of 3 cm never exceeds both, jitter of 5 cm in one frame of thirty.
inline constexpr double most_uneven = 2.5, least_uneven_m = 0.15;
/// Mean speed of the joints [m/s], and the smallest distance that counts [m]. Sprinters reach 12 m/s, the
/// worst error of the captures 9 m/s.
inline constexpr double fastest_m_per_s = 20;
inline constexpr double least_jump_m = 0.1;

}  // namespace person_bounds

/// A sentence without dynamic memory, because a step must not allocate.
struct PersonDoubt {
  std::array<char, 160> text{};
  std::string_view sentence() const { return text.data(); }
};

/// Why a pose is not a person's: "lfemur is 45.20 m long; no bone of a person is longer than 2 m". None if it
/// can be one. @param pose world space [m], Y up, floor near y = 0; need not be finite
std::optional<PersonDoubt> why_not_a_person(const Pose& pose);

/// Whether the step is too fast for a person. @param elapsed_s above 0
bool is_jump_beyond_a_person(const Pose& from, const Pose& to, double elapsed_s);

/// Counts of the poses and steps of a clip that cannot be a person's.
struct PersonDoubts {
  std::size_t poses = 0, jumps = 0;
  std::size_t first_pose = 0, first_jump = 0;  ///< frame indices; valid if there is one
  std::string first_reason;                    ///< of the first pose that is not a person's
};
PersonDoubts person_doubts(std::span<const Pose> poses, double fps);

}  // namespace abrazo
