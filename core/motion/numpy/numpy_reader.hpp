#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/joints/joint_order.hpp"
#include "core/motion/joints/named_motion.hpp"
#include "core/motion/numpy/smpl_body.hpp"

namespace abrazo {

/// Reads positions (frames, joints, 3) from NumPy's files: a .npy holds one performer, a .npz one as
/// `positions` (or as its only such array), or several as `person1`, `person2`, ... Beside them
/// `joint_names`, `fps`, `up` ("y", "z") and `metres_per_unit` are honoured. NaN is a gap. Pickled objects
/// are never read.
/// @param order  which joint is which, over what the file says; where neither says it, the built-in order
/// that alone has this number of joints is used, with a warning
/// @param body  of a file with the parameters of an SMPL body
/// @return an Error that says what is missing: names for the joints, the body file of SMPL parameters, a
/// person where there is a robot
Result<std::vector<NamedMotion>> read_numpy(std::string_view bytes, const std::optional<JointOrder>& order,
                                            std::string_view where, const SmplBodyFile& body = {});

/// Whether a ZIP archive begins with a .npy, which makes it a .npz. @param head of a file
bool begins_as_npz(std::string_view head);

}  // namespace abrazo
