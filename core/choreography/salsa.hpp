#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/library/paired_take.hpp"

namespace abrazo {

/// A generated dance with known roles and labels.
struct ChoreographyOptions {
  std::uint64_t seed = 1;
  double minutes = 1;  ///< in all
  double fps = 60;
  double tempo_bpm = 175;  ///< beats; an 8-count takes 8 of them
  double leader_height_m = 1.80;
  double follower_height_m = 1.66;
  double take_seconds = 20;  ///< length of a take; the minutes are divided into takes of about this length
};

/// Salsa pairs: performer A leads. Basics in open and closed hold, a led turn and a cross body lead, in
/// random order, joined without a seam. Hands that hold one another meet, planted feet stand still, bone
/// lengths are constant.
/// @throws std::invalid_argument when an option is not positive, or a height is not between 1.4 and 2.2 m
std::vector<PairedTake> generate_salsa(const ChoreographyOptions& options);

}  // namespace abrazo
