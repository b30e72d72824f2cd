#include "tests/bench/kkt_system.hpp"

#include <algorithm>

namespace abrazo::bench {

void refinement_side(const KktSystem& system, const std::vector<double>& solution,
                     std::vector<double>& right) {
  right.assign(system.right.size(), 0);
  std::copy(system.right.begin() + KktSystem::unknowns, system.right.end(),
            right.begin() + KktSystem::unknowns);
  for (int column = 0; column < KktSystem::unknowns; ++column) {
    const auto at = static_cast<std::size_t>(column);
    for (auto entry = static_cast<std::size_t>(system.column_starts[at]);
         entry < static_cast<std::size_t>(system.column_starts[at + 1]); ++entry)
      if (system.rows[entry] >= KktSystem::unknowns)
        right[static_cast<std::size_t>(system.rows[entry])] -= system.values[entry] * solution[at];
  }
}

}  // namespace abrazo::bench
