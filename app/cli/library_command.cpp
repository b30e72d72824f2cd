#include "app/cli/library_command.hpp"

namespace abrazo::app {

void add_library_command(CommandLine& line) {
  CLI::App* library = line.app.add_subcommand("library", "build and inspect motion libraries");
  library->require_subcommand(1);
  add_library_build(*library, line);
  add_library_info(*library, line);
  add_library_plan(*library, line);
  add_library_pair(*library, line);
}

}  // namespace abrazo::app
