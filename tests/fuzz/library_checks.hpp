#pragma once

#include "core/library/store/motion_library.hpp"

namespace abrazo::fuzz {

/// Asks a library that was accepted for all it has: every pair with pose, mesh, bodies and label, then the
/// nearest pairs of some of them with their costs. All of it is finite and within bounds, or the library says
/// that it is damaged.
void expect_usable(const MotionLibrary& library);

}  // namespace abrazo::fuzz
