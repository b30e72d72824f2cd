#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/motion/joints/motion_format.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Reads the animated skeletons of an FBX, glTF or Collada file in the program `abrazo-scene-reader`: what
/// such a file of a stranger does to its reader, it does to a process with limits of memory, time and files.
/// Otherwise as read_scene (assimp_scene.hpp), to the bit.
/// @param progress  asking to stop kills the process
/// @return an Error with what happened there and what to do; also where that program is not found: a scene is
///         never read without limits
Result<std::vector<NamedMotion>> read_scene_apart(std::string_view bytes, MotionFormat format,
                                                  const std::string& file, const std::string& animation,
                                                  const Progress& progress);

/// Where the program is looked for: as the environment's ABRAZO_SCENE_READER says, else beside the code that
/// asks (a program, or a module that a program has loaded), then where it is installed from there.
std::vector<std::filesystem::path> scene_reader_places();

/// What that program may take for a file of so many bytes.
struct SceneLimits {
  std::size_t memory_bytes = 0;  ///< of addresses
  int processor_s = 0;
  double wall_s = 0;
};
SceneLimits scene_limits(std::size_t file_bytes);

/// How the program ends when it has no answer.
enum class SceneReaderExit { Answered = 0, WrongUse = 2, OutOfMemory = 3, NoLimits = 4 };

}  // namespace abrazo
