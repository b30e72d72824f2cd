#pragma once

#include <memory>

#include "tests/bench/kkt_system.hpp"

namespace abrazo::bench {

enum class Pivoting { Partial, Full };

/// Eigen's dense LU of the whole system.
std::unique_ptr<KktSolver> dense_solver(Pivoting pivoting);

/// The same in extended precision, with partial pivoting: what the answer is, up to 1e-12 m. Slow.
std::unique_ptr<KktSolver> reference_solver();

}  // namespace abrazo::bench
