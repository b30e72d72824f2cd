#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/motion/files/motion_reading.hpp"
#include "core/opening/file_kinds.hpp"
#include "core/opening/material.hpp"

namespace abrazo {

/// What a person wants to open, and with what.
struct OpeningWish {
  std::vector<FileToOpen> files;
  Material open;           ///< what is open now
  std::string joint_maps;  ///< folder of joint maps that are tried where no built-in one fits; empty = none
  std::string autosaves;   ///< see open_session
  /// How the motion is read, but for its files; none = as was said of files alike, else as found.
  std::optional<MotionReading> said = {};
  std::string import_rules = {};  ///< folder of what was said of files alike; empty = none
};

/// What opening these files gives, in addition to what is open now. A library file or manifest replaces the
/// library, a motion replaces the input, a session file is opened with its library; what is still missing
/// comes from the library or the generated dance.
Result<Material> open_files(const OpeningWish& wish, const Progress& progress);

/// Reads a motion as the input.
Status read_input(const MotionReading& reading, Material& material, const Progress& progress = {});

}  // namespace abrazo
