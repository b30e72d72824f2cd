#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace abrazo::app {

/// The option `--character`: the bodies as a humanoid of another program, one file each.
/// @param files  those that are written instead of the output, for the help
void add_character_option(CLI::App& command, std::string& character, CLI::Option* output,
                          const std::string& files);

}  // namespace abrazo::app
