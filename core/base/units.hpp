#pragma once

#include <numbers>

namespace abrazo {

inline constexpr double radians_per_degree = std::numbers::pi / 180;
inline constexpr double cm_per_m = 100, mm_per_m = 1000;
inline constexpr double ms_per_s = 1000, us_per_ms = 1000;

}  // namespace abrazo
