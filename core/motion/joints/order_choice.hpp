#pragma once

#include <vector>

#include "core/motion/joints/joint_order.hpp"

namespace abrazo {

/// Which of several orders an array of positions has: the one in which thighs, shins, upper arms and forearms
/// keep their lengths over time and are as long on the left as on the right.
/// @param orders  of the number of joints of the frames
/// @param frames  joints x 3 each; some of them are looked at
/// @return null if none or more than one may be right
const JointOrder* order_of_steady_bones(const std::vector<const JointOrder*>& orders,
                                        const std::vector<Positions>& frames);

}  // namespace abrazo
