#pragma once

#include <cstdint>

namespace abrazo {

/// Which value of a figure is best. None: neither higher nor lower is better.
enum class FigureGoal : std::uint8_t { None, Lowest, Highest, NearestZero };

}  // namespace abrazo
