#pragma once

#include <span>
#include <string>

#include "core/base/result.hpp"
#include "core/motion/clip.hpp"

namespace abrazo::app {

/// Whether clips can be written to a file of this name; the Error names the types there are.
Status check_clip_file(const std::string& path);

/// The content of a .bvh, .glb or .csv file with these clips.
Result<std::string> clip_file_content(const std::string& path, std::span<const Clip> clips);

/// Writes it, whole or not at all.
Status write_clip_file(const std::string& path, std::span<const Clip> clips);

}  // namespace abrazo::app
