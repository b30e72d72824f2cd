#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo {

/// Whether a file can be written there, asked before the work rather than after it: the folder exists, what
/// stands at the name is a regular file or nothing, and it is none of the `inputs`.
Status check_output(const std::string& path, const std::vector<std::string>& inputs);

/// "dance.bvh" with "_active" is "dance_active.bvh"; a name without extension gets it at the end.
std::string with_suffix(const std::string& path, const std::string& suffix);

}  // namespace abrazo
