#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/cli/command_line.hpp"
#include "core/base/result.hpp"
#include "core/motion/files/clip_file.hpp"
#include "core/motion/files/motion_reading.hpp"

namespace abrazo::app {

/// Options of all subcommands that read a motion, without the file itself.
void add_reading_options(CLI::App& command, MotionReading& reading);

/// A Progress that shows nothing and stops when the program is asked to end.
bool until_interrupted(double fraction, std::string_view doing);

/// The one performer wanted. What the reader found odd about this one is printed.
Result<ImportedClip> read_performer(CommandLine& line, const MotionReading& reading);

/// Prints the warnings about a file.
void warn_of_import(CommandLine& line, const MotionReading& reading, const ImportedClip& imported);

/// --out-units, --out-up and --out-joints of a motion file that is written.
struct WrittenSpace {
  std::string units, up, joints;
};
void add_space_options(CLI::App& command, WrittenSpace& words);
Result<ClipFileSpace> file_space(const WrittenSpace& words);

}  // namespace abrazo::app
