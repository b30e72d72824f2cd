#pragma once

#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/motion/files/import_clip.hpp"
#include "core/opening/file_kinds.hpp"
#include "core/opening/material.hpp"

namespace abrazo {

/// What a person wants to open, and with what.
struct OpeningWish {
  std::vector<FileToOpen> files;
  Material open;           ///< what is open now
  std::string joint_maps;  ///< folder of joint maps that are tried where no built-in one fits; empty = none
  std::string autosaves;   ///< see open_session
  ImportOptions said;      ///< what a person knows of the motion
};

/// What opening these files gives, in addition to what is open now. A library file or manifest replaces the
/// library, a motion replaces the input, a session file is opened with its library; what is still missing
/// comes from the library or the generated dance.
Result<Material> open_files(const OpeningWish& wish, const Progress& progress);

/// Reads the motion of these files as the input.
Status read_input(const SortedFiles& files, const ImportOptions& said, Material& material,
                  const Progress& progress = {});

}  // namespace abrazo
