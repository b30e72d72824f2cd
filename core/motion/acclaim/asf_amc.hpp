#pragma once

#include <string_view>

#include "core/base/result.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Reads an Acclaim skeleton and motion. Points are "root" and the end of every bone, named like the bone.
/// Transform of a bone: world(b) = world(parent) C R C^-1 with C = Rz Ry Rx of its `axis` (in the axis order
/// given), R of its dofs; end(b) = end(parent) + world(b) direction length. Lengths stay in file units;
/// `metres_per_unit` is (1 / length unit) x 2.54 / 100, the CMU convention, if the file states a length unit.
/// @param asf_where, amc_where  names used in messages
Result<NamedMotion> read_asf_amc(std::string_view asf, std::string_view asf_where, std::string_view amc,
                                 std::string_view amc_where);

}  // namespace abrazo
