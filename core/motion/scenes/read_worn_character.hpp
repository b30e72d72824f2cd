#pragma once

#include <memory>
#include <string>

#include "core/base/result.hpp"

namespace abrazo {

struct WornCharacter;

/// Reads a humanoid character (GLB, VRM 0.x or 1.0) with its rig and skin. The Error names the file and what
/// is expected.
Result<std::shared_ptr<const WornCharacter>> read_worn_character(const std::string& file);

}  // namespace abrazo
