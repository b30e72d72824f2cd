#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Reads positions from a delimited table (comma, semicolon or tab; decimal commas with the latter two):
/// - Abrazo's own format: frame,time,root_x,root_y,root_z,..., with "active." before the names if there are
/// several;
/// - columns name_x, name.x, name:X, "name X", nameX or x_name, optionally with a unit ("root_x [mm]");
/// - names above x, with X, Y, Z in the line below (Vicon Nexus and others);
/// - exports of OptiTrack Motive: bones if there are any, else markers. Empty fields are gaps.
Result<std::vector<NamedMotion>> read_point_csv(std::string_view text, std::string_view where);

/// Whether a table's first lines are those of positions (columns x, y and z per point), not of labels.
bool holds_positions(std::string_view head);

}  // namespace abrazo
