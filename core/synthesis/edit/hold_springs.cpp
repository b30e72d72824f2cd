#include "core/synthesis/edit/hold_springs.hpp"

#include "core/motion/body/joint_set.hpp"

namespace abrazo {

void add_hold_springs(std::span<const HandHold> holds, double weight, VertexMatrix& energy,
                      PairPose& linear) {
  for (const HandHold& hold : holds) {
    const double stiffness = weight * hold.strength;
    const int a = hold.active_left ? joints::left_hand : joints::right_hand;
    const int s = joint_count + (hold.passive_left ? joints::left_hand : joints::right_hand);
    energy(a, a) += stiffness;
    energy(s, s) += stiffness;
    energy(a, s) -= stiffness;
    energy(s, a) -= stiffness;
    linear.row(s) += stiffness * hold.offset.transpose();
    linear.row(a) -= stiffness * hold.offset.transpose();
  }
}

}  // namespace abrazo
