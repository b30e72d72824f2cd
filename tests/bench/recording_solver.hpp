#pragma once

#include <span>
#include <vector>

#include "core/synthesis/edit/constrained_solver.hpp"

namespace abrazo::bench {

/// One minimisation as the pipeline posed it, and its answer: min 1/2 tr(V^T K V) - tr(R^T V) with the rows
/// that bind held.
struct PosedSystem {
  VertexMatrix energy;                 ///< K, with what was stiffened
  PairPose linear;                     ///< R
  std::vector<ConstraintRow> binding;  ///< rows that hold at the answer
  PairPose answer;                     ///< V
};

/// What one frame asked of the solver, in order: enough to ask the same again.
struct FrameCalls {
  struct Stiffened {
    int a = 0, b = 0;
    double c = 0;
  };
  struct Call {
    bool new_energy = false;  ///< set_energy() came before
    bool projects = false;    ///< project() in place of solve()
    std::vector<Stiffened> stiffened;
    PairPose linear;  ///< R; where from when it projects
    std::vector<ConstraintRow> rows;
    std::vector<char> active;  ///< before
    PosedSystem posed;
  };
  VertexMatrix energy;
  std::vector<Call> calls;
};

}  // namespace abrazo::bench

namespace abrazo {

/// The production solver under another name, which notes every call in `notes`. The production sources of
/// the editor and the pipeline are compiled once more with it in the solver's place: recording_names.hpp.
class RecordingSolver : public ConstrainedSolver {
 public:
  static inline thread_local bench::FrameCalls* notes = nullptr;

  bool set_energy(const VertexMatrix& energy);
  void relax();
  void stiffen(int a, int b, double c);
  bool solve(const PairPose& linear, std::span<const ConstraintRow> rows, std::vector<char>& active,
             PairPose& positions);
  bool project(const PairPose& from, std::span<const ConstraintRow> rows, std::vector<char>& active,
               PairPose& positions);

 private:
  void note(bool projects, const PairPose& linear, std::span<const ConstraintRow> rows,
            const std::vector<char>& before, const std::vector<char>& after, const PairPose& answer);

  VertexMatrix energy_;
  bool is_new_ = false;
  std::vector<bench::FrameCalls::Stiffened> stiffened_;
};

}  // namespace abrazo
