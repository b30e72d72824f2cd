#pragma once

#include "app/cli/command_line.hpp"

namespace abrazo::app {

// One function per file: declares a subcommand of `library` and its action.
void add_library_build(CLI::App& library, CommandLine& line);
void add_library_info(CLI::App& library, CommandLine& line);
void add_library_plan(CLI::App& library, CommandLine& line);
void add_library_pair(CLI::App& library, CommandLine& line);

}  // namespace abrazo::app
