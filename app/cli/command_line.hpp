#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "core/base/error.hpp"
#include "core/base/progress.hpp"

namespace abrazo::app {

/// What every subcommand shares.
struct CommandLine {
  CLI::App app{
      "Abrazo: a virtual partner for close interactions, from recorded pairs and their interaction meshes."};
  bool quiet = false;
  int status = 0;  ///< exit status the subcommand that ran has set: 0 done, 1 could not be done
};

/// Prints one sentence on stderr and sets the exit status to 1.
void fail(CommandLine& line, const Error& error);

/// A progress line on stderr when that is a terminal and --quiet was not given; otherwise says nothing.
Progress terminal_progress(const CommandLine& line);

// One function per subcommand file: declares the subcommand's options and what it runs.
void add_motion_command(CommandLine& line);
void add_library_command(CommandLine& line);
void add_synth_command(CommandLine& line);
void add_demo_command(CommandLine& line);

}  // namespace abrazo::app
