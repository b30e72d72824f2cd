#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/motion/files/motion_reading.hpp"
#include "core/opening/file_kinds.hpp"
#include "core/opening/material.hpp"
#include "core/opening/opened_session.hpp"

namespace abrazo {

/// Asks for the places of the missing data of a session. Called on the thread that opens it, which waits.
/// @return none: the session is not opened
using LocateMissing = std::function<std::optional<Places>(const std::shared_ptr<const OpenedProject>& project,
                                                          const Progress& progress)>;

/// Files that a person wants to open, and the data to open them with.
struct OpeningWish {
  std::vector<FileToOpen> files;
  Material open;           ///< what is open now
  std::string joint_maps;  ///< folder of joint maps that are tried if no built-in one fits; empty = none
  std::string autosaves;   ///< see open_session
  /// How to read the motion, without its files; none = by the rule for similar files, otherwise as found.
  std::optional<MotionReading> said = {};
  std::string import_rules = {};  ///< folder of rules for similar files; empty = none
  /// For a session that is opened without other files; empty: what is missing is among the warnings.
  LocateMissing locate = {};
};

/// Opens files in addition to those that are open. A library file or manifest replaces the
/// library, a motion replaces the input, a session file is opened with its library. A missing library or
/// input is taken from the generated dance or the library. @return an Error "cancelled" if `locate` returns
/// none
Result<Material> open_files(const OpeningWish& wish, const Progress& progress);

/// Reads a motion as the input.
Status read_input(const MotionReading& reading, Material& material, const Progress& progress = {});

}  // namespace abrazo
