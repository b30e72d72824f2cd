#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo {

/// Checks before long work that a file can be written: the folder exists, the path is a regular file or free,
/// and it is none of the `inputs`.
Status check_output(const std::string& path, const std::vector<std::string>& inputs);

/// "dance.bvh" with "_active" is "dance_active.bvh"; a name without extension gets it at the end.
std::string with_suffix(const std::string& path, const std::string& suffix);

}  // namespace abrazo
