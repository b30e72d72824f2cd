#include <fmt/core.h>

#include <cstdio>
#include <exception>

#include "app/cli/command_line.hpp"
#include "core/base/version.hpp"

int main(int argc, char** argv) {
  using namespace abrazo;
  app::CommandLine line;
  line.app.name("abrazo");
  line.app.set_version_flag("--version", std::string("abrazo ") + version());
  line.app.require_subcommand(1);
  line.app.fallthrough();
  line.app.add_flag("--quiet", line.quiet, "no progress on stderr");
  app::add_motion_command(line);
  app::add_library_command(line);
  app::add_synth_command(line);
  app::add_demo_command(line);
  try {
    line.app.parse(argc, argv);
  } catch (const CLI::ParseError& refusal) {
    // CLI11 has its own codes for wrong usage; callers are promised 2. Help and version end with 0.
    return line.app.exit(refusal) == 0 ? 0 : 2;
  } catch (const std::exception& failure) {
    fmt::print(stderr, "abrazo: {}\n", failure.what());
    return 1;
  }
  return line.status;
}
