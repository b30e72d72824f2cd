#pragma once

#include <string>
#include <vector>

#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Splits a motion by the prefixes of point names ("Anna:LASI", "Anna:RASI"; "active.root"): one performer
/// per prefix with at least 8 points, named by the prefix, which is removed from the points. Points without a
/// prefix are a performer, too, if they are a known body or nobody else is; otherwise left out with a
/// warning. If no body that Abrazo knows is found so, also "Anna_LASI", "Anna-LASI" and the like are
/// prefixes, provided that they give one. A motion without prefixes is returned unchanged.
/// @param marks characters that end a prefix; sides ("L.Heel") are not prefixes
/// @param beginnings prefixes declared by the file that do not end in a mark ("Anna_")
std::vector<NamedMotion> split_performers(NamedMotion motion, const std::string& marks = ":",
                                          const std::vector<std::string>& beginnings = {});

/// Makes names unique by "_2", "_3", ... with a warning. @param what "marker", "node"
void make_names_unique(std::vector<std::string>& names, const std::string& what,
                       std::vector<ImportWarning>& warnings);

/// Removes the common prefix of all names, up to '_', ':', '|', '.' or '-': "Armature_Hips",
/// "Armature_Spine".
void strip_common_beginning(std::vector<std::string>& names);

/// "A, B, C and 12 more".
std::string some_of(const std::vector<std::string>& names, std::size_t most = 6);

}  // namespace abrazo
