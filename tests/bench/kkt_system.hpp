#pragma once

#include <vector>

namespace abrazo::bench {

/// The Lagrange system of one morph step as the paper puts it (Eq. 11): x, y, z of 50 vertices and one
/// multiplier for each row,
///   [ K (x) I_3   H^T   ] [ V ]   [ R ]
///   [ H          -eps I ] [ l ] = [ h ]
/// in compressed columns, sorted. Plain numbers: those who solve it are compiled for this very processor,
/// which must not touch types of the library.
struct KktSystem {
  static constexpr int unknowns = 150;
  int size = 0;
  std::vector<int> column_starts, rows;
  std::vector<double> values;
  std::vector<double> right;

  int multipliers() const { return size - unknowns; }
};

/// One factorisation of a whole system, then a solution and one step of refinement against eps, which is
/// what the production solver does as well. @return what the solver calls singular
class KktSolver {
 public:
  virtual ~KktSolver() = default;
  /// @param[out] solution  V and multipliers
  virtual bool solve(const KktSystem& system, std::vector<double>& solution) = 0;
};

/// right side of the refinement: [0; h - H V].
void refinement_side(const KktSystem& system, const std::vector<double>& solution,
                     std::vector<double>& right);

}  // namespace abrazo::bench
