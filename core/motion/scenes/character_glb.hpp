#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/body/clip.hpp"

namespace abrazo {

/// A humanoid character of another program (GLB, VRM 0.x or 1.0) that performs a clip: the same file, whose
/// animations are replaced by one, "motion", of rotations of its own bones and the translation of its hips.
/// Mesh, skin, rest pose and everything else stay as they are. Its bones are those that VRM names, or found
/// by the names of Mixamo or VRM. Upper and lower arms and legs point where the clip's do, other bones turn
/// as the clip's do from a T-pose; the path is scaled by the legs, and feet stand on the same floor.
/// @param character content of the file
/// @param where     its name, for messages
/// @return an Error if it is no GLB, or lacks one of the bones that every VRM has
Result<std::string> write_character_glb(std::string_view character, const Clip& clip,
                                        const std::string& where);

/// Checks that a character with its motion can be written to a file of this name: .glb or .vrm.
Status check_character_file(const std::string& output);

/// As write_character_glb, of the character in a file, for each of the clips.
Result<std::vector<std::string>> character_performances(const std::string& character,
                                                        std::span<const Clip> clips);

}  // namespace abrazo
