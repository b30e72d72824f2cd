#pragma once

#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

class NumpyFile;

/// A body model of the SMPL family as the user has it: a .npz with v_template (V, 3), shapedirs (V, 3, S),
/// J_regressor (J, V) and kintree_table (2, J). It is never shipped, and never unpickled.
struct SmplBodyFile {
  std::string_view bytes = {};
  std::string where = {};  ///< empty: none
};

/// Whether the arrays are pose parameters: poses and trans (AMASS), or root_orient and pose_body.
bool holds_smpl_parameters(const NumpyFile& file);

/// The positions of the body's joints in metres [frames x J x 3], named for the joint map "smpl":
///   J_rest = J_regressor (v_template + shapedirs betas);  p_root = J_rest_root + trans;
///   p_j = p_parent + R_parent (J_rest_j - J_rest_parent),  R_j = R_parent exp(pose_j)
/// after Loper et al., SMPL, ACM TOG 34 (2015), 248. Only joints: no skin, no pose blend shapes, which move
/// none of them. Nothing is assumed on the axis that points up.
/// @return an Error where shapes of the parameters and of the body do not go together
Result<NamedMotion> read_smpl(const NumpyFile& parameters, const SmplBodyFile& body);

}  // namespace abrazo
