#pragma once

#include <memory>
#include <string>

#include "tests/bench/kkt_system.hpp"

namespace abrazo::bench {

enum class Ordering {
  Each,   ///< symbolic and numeric factorisation for each system
  Reused  ///< symbolic only where the pattern of entries is another than that of the system before
};

/// UMFPACK with its defaults, but for its own iterative refinement, which is off: it costs time.
std::unique_ptr<KktSolver> umfpack_solver(Ordering ordering);

/// Its version and the BLAS beneath it.
std::string umfpack_version();

}  // namespace abrazo::bench
