#include "core/synthesis/edit/turning_bones.hpp"

namespace abrazo {

void damp_turning_bones(const RigidDistances& lengths, const PairPose& iterate, bool solved,
                        ConstrainedSolver& solver, PairPose& linear) {
  solver.relax();
  if (!solved) return;
  for (std::size_t n = 0; n < lengths.size(); ++n) {
    const RigidDistance& rigid = lengths[n];
    const double tension = -solver.multiplier(n);
    if (rigid.length_m < 1e-6 || tension < 0.3 * rigid.length_m * solver.stiffness(rigid.a, rigid.b))
      continue;
    const double c = tension / rigid.length_m;
    solver.stiffen(rigid.a, rigid.b, c);
    const Eigen::RowVector3d apart = iterate.row(rigid.a) - iterate.row(rigid.b);
    linear.row(rigid.a) += c * apart;
    linear.row(rigid.b) -= c * apart;
  }
}

}  // namespace abrazo
