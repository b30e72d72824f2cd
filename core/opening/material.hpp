#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/motion/body/clip.hpp"
#include "core/motion/files/import_clip.hpp"

namespace abrazo::app {

struct OpenedProject;
struct RecordedSession;

/// What a live session runs on: a library, and a clip that stands in for the user; or a recorded session,
/// whose clip has a name and a rate but no poses.
struct Material {
  std::shared_ptr<const MotionLibrary> library;
  std::string library_file;  ///< library or manifest; empty when it was generated, or built and not saved
  Clip input;
  /// Motion, skeleton and joint map that the input was read from; none when it is a take of the library.
  std::vector<std::string> input_files;
  std::vector<std::string> excluded_takes;  ///< the input's own take, where it comes from the library
  std::vector<std::string> warnings;
  std::shared_ptr<const RecordedSession> recorded;  ///< null: nothing was recorded before
  std::shared_ptr<const OpenedProject> project;     ///< null: what is open was not opened from a session file
};

/// What opening these files gives, in addition to what is open now. A library file or manifest replaces the
/// library, a motion replaces the input, a session file is opened with its library; what is still missing
/// comes from the library or the demo.
/// @param said  what a person knows of the motion
Result<Material> load_material(const std::vector<std::string>& files, const Material& open,
                               const Progress& progress, const ImportOptions& said = {});

/// Whether it is a motion file by its name; a table counts when its first lines are those of positions. Of
/// two or more, only a person knows what they are for.
bool is_motion_file(const std::string& file);

/// Whether it says which points are joints. Reads a .json.
bool is_joint_map_file(const std::string& file);

/// What is open with another library: its last take plays the user.
Material with_library(std::shared_ptr<const MotionLibrary> library, std::vector<std::string> warnings);

/// What is open with a take of its library as the user, who is then not answered from that take.
Material danced_with(const Material& open, int take);

/// The core's messages name options of `abrazo`; in the window the same is done otherwise.
std::string in_words_of_the_window(std::string message);

/// The active performer of a take as the library has it, world.
Clip clip_of_take(const MotionLibrary& library, int take);

}  // namespace abrazo::app
