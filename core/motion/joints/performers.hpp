#pragma once

#include <string>
#include <vector>

#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Points whose names begin alike ("Anna:LASI", "Anna:RASI"; "active.root") are one performer: a motion for
/// each beginning that has at least 8 points, named by it, its points without it. What belongs to none of
/// them is left out with a warning. A motion without such beginnings comes back as it is.
/// @param marks       of which one ends a beginning; names of a side ("L.Heel") are none
/// @param beginnings  that the file declares, where they do not end in a mark ("Anna_")
std::vector<NamedMotion> split_performers(NamedMotion motion, const std::string& marks = ":",
                                          const std::vector<std::string>& beginnings = {});

/// Makes names unique by "_2", "_3", ... and says so. @param what  "marker", "node"
void make_names_unique(std::vector<std::string>& names, const std::string& what,
                       std::vector<ImportWarning>& warnings);

/// Takes away what all names begin with, up to a '_', ':' or '|': "Armature_Hips", "Armature_Spine".
void strip_common_beginning(std::vector<std::string>& names);

/// "A, B, C and 12 more".
std::string some_of(const std::vector<std::string>& names, std::size_t most = 6);

}  // namespace abrazo
