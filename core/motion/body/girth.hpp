#pragma once

#include "core/motion/body/body.hpp"

namespace abrazo {

/// Capsules follow the height: the ratio of the heights, 1 if the first body has none.
inline double girth(const Body& from, const Body& to) {
  constexpr double shortest_m = 1e-6;
  const double from_m = from.height();
  return from_m > shortest_m ? to.height() / from_m : 1;
}

}  // namespace abrazo
