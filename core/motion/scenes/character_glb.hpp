#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/body/clip.hpp"

namespace abrazo {

/// A humanoid character of another program (GLB, VRM 0.x or 1.0) that performs clips of one scene: for each
/// the same file, whose animations are replaced by one, "motion", of rotations of its own bones and the
/// translation of its hips. Mesh, skin, rest pose and everything else stay as they are. Its bones are those
/// that VRM names, or found by the names of Mixamo or VRM. @see RigMotion. The path of all is scaled by the
/// mean of their legs: hands that meet in the clips meet in the files.
/// @param character content of the file
/// @param where     its name, for messages
/// @return an Error if it is no GLB, or lacks one of the bones that every VRM has
Result<std::vector<std::string>> write_character_glbs(std::string_view character, std::span<const Clip> clips,
                                                      const std::string& where);

/// Checks that a character with its motion can be written to a file of this name: .glb or .vrm.
Status check_character_file(const std::string& output);

/// As write_character_glbs, of the character in a file.
Result<std::vector<std::string>> character_performances(const std::string& character,
                                                        std::span<const Clip> clips);

}  // namespace abrazo
