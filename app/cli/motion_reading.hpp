#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/cli/command_line.hpp"
#include "core/base/result.hpp"
#include "core/motion/files/clip_file.hpp"
#include "core/motion/files/import_clip.hpp"

namespace abrazo::app {

/// Options of a command about a motion file that it reads.
struct MotionReading {
  std::string file, skeleton, joint_map, up;
  double metres_per_unit = 0, fps = 0;  ///< 0 = not given
  std::string performer;                ///< a number from 1, or a name; empty = not given
  std::string animation;                ///< empty = not given
};

/// The options beside the file itself, the same for each subcommand that reads a motion.
void add_reading_options(CLI::App& command, MotionReading& reading);

/// All performers of the file, or the one that is asked for.
Result<std::vector<ImportedClip>> read_performers(const MotionReading& reading);

/// The one performer wanted: an Error that says how many there are when that is not clear. What the reader
/// found odd about this one is printed.
Result<ImportedClip> read_performer(CommandLine& line, const MotionReading& reading);

/// What was odd about a file, as warnings.
void warn_of_import(CommandLine& line, const MotionReading& reading, const ImportedClip& imported);

/// --out-units and --out-up of a motion file that is written.
void add_space_options(CLI::App& command, std::string& units, std::string& up);
ClipFileSpace file_space(const std::string& units, const std::string& up);

}  // namespace abrazo::app
