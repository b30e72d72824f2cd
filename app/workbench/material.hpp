#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/library/motion_library.hpp"
#include "core/motion/clip.hpp"

namespace abrazo::app {

/// What a live session runs on: a library, and a clip that stands in for the user.
struct Material {
  std::shared_ptr<const MotionLibrary> library;
  Clip input;
  std::vector<std::string> excluded_takes;  ///< the input's own take, where it comes from the library
  std::vector<std::string> warnings;
};

/// A minute of generated dance, and a leader whom the library has not seen.
Result<Material> make_demo(const Progress& progress);

/// What opening these files gives, in addition to what is open now. A library file or manifest replaces the
/// library, a motion replaces the input; what is still missing comes from the library or the demo.
Result<Material> load_material(const std::vector<std::string>& files, const Material& open,
                               const Progress& progress);

/// The active performer of a take as the library has it, world.
Clip clip_of_take(const MotionLibrary& library, int take);

}  // namespace abrazo::app
