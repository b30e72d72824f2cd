#include "core/synthesis/edit/hold_springs.hpp"

#include "core/motion/body/joint_set.hpp"

namespace abrazo {

void add_spring(int a, int b, double stiffness, const Vec3& offset, VertexMatrix& energy, PairPose& linear) {
  energy(a, a) += stiffness;
  energy(b, b) += stiffness;
  energy(a, b) -= stiffness;
  energy(b, a) -= stiffness;
  linear.row(b) += stiffness * offset.transpose();
  linear.row(a) -= stiffness * offset.transpose();
}

void add_hold_springs(std::span<const HandHold> holds, double weight, VertexMatrix& energy,
                      PairPose& linear) {
  for (const HandHold& hold : holds)
    add_spring(hold.active_left ? joints::left_hand : joints::right_hand,
               joint_count + (hold.passive_left ? joints::left_hand : joints::right_hand),
               weight * hold.strength, hold.offset, energy, linear);
}

}  // namespace abrazo
