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

/// Reads the animated skeletons of an FBX, glTF or Collada file in a separate program, `abrazo-scene-reader`,
/// which has limits of memory, processor time and files: a damaged or malicious file cannot harm this
/// process. The result is that of read_scene (assimp_scene.hpp), to the bit.
/// @param progress  a request to stop kills the program
/// @return an Error that says what happened and what to do; also if the program is not found, because a scene
///         is never read without limits
Result<std::vector<NamedMotion>> read_scene_apart(std::string_view bytes, MotionFormat format,
                                                  const std::string& file, const std::string& animation,
                                                  const Progress& progress);

/// Places where the program is searched, in this order: the environment variable ABRAZO_SCENE_READER alone if
/// it is set; otherwise the folder of the calling code (a program or a loaded module), then the place where
/// it is installed relative to that.
std::vector<std::filesystem::path> scene_reader_places();

/// Limits of that program for a file of this size.
struct SceneLimits {
  std::size_t memory_bytes = 0;  ///< of addresses
  int processor_s = 0;
  double wall_s = 0;
};
SceneLimits scene_limits(std::size_t file_bytes);

/// Exit codes of the program.
enum class SceneReaderExit { Answered = 0, WrongUse = 2, OutOfMemory = 3, NoLimits = 4 };

}  // namespace abrazo
