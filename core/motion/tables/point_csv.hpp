#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Reads positions from a table with separators (comma, semicolon or tab; decimal commas with the latter
/// two):
/// - what Abrazo writes: frame,time,root_x,root_y,root_z,..., with "active." before the names of several;
/// - columns name_x, name.x, name:X, "name X", nameX or x_name, each with a unit behind ("root_x [mm]");
/// - names over their x, with X, Y, Z in the line below (Vicon Nexus and others);
/// - exports of OptiTrack Motive: bones where there are any, else markers.
/// Empty fields are gaps.
Result<std::vector<NamedMotion>> read_point_csv(std::string_view text, std::string_view where);

/// Whether a table's first lines are those of positions (a column for x, y and z of each point) and not of
/// labels.
bool holds_positions(std::string_view head);

}  // namespace abrazo
