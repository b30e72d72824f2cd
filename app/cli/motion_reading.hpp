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
  std::string file, skeleton, joint_map, joints, up;
  double metres_per_unit = 0, fps = 0;  ///< 0 = not given
  int performer = 0;                    ///< from 1; 0 = not given
};

/// The options beside the file itself, the same for each subcommand that reads a motion.
void add_reading_options(CLI::App& command, MotionReading& reading);
void add_performer_option(CLI::App& command, MotionReading& reading);

/// All performers of the file.
Result<std::vector<ImportedClip>> read_performers(const MotionReading& reading);

/// The one performer wanted: an Error that says how many there are when that is not clear. What the reader
/// found odd about this one is printed.
Result<ImportedClip> read_performer(CommandLine& line, const MotionReading& reading);

/// What was odd about a file, as warnings.
void warn_of_import(CommandLine& line, const MotionReading& reading, const ImportedClip& imported);

/// --out-units, --out-up and --out-joints of a motion file that is written.
struct WrittenSpace {
  std::string units, up, joints;
};
void add_space_options(CLI::App& command, WrittenSpace& words);
Result<ClipFileSpace> file_space(const WrittenSpace& words);

}  // namespace abrazo::app
