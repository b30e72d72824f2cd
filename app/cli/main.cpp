#include <fmt/core.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>

#include "app/cli/command_line.hpp"
#include "app/cli/interruption.hpp"
#include "core/base/file_limit.hpp"
#include "core/base/version.hpp"

int main(int argc, char** argv) {
  using namespace abrazo;
  app::CommandLine line;
  line.app.name("abrazo");
  line.app.set_version_flag("--version", std::string("abrazo ") + version());
  line.app.require_subcommand(1);
  line.app.fallthrough();
  line.app.failure_message(app::usage_message);
  line.app.add_flag("--quiet", line.quiet,
                    "no progress, warnings or summary: only errors and the requested output");
  app::add_motion_command(line);
  app::add_library_command(line);
  app::add_synth_command(line);
  app::add_demo_command(line);
  app::add_evaluate_command(line);
  app::add_sweep_command(line);
  app::add_live_command(line);
  app::add_send_command(line);
  app::add_export_command(line);
  app::add_labels_command(line);
  app::add_render_command(line);
  app::add_suggest_command(line);
  app::add_retarget_command(line);
  app::add_session_command(line);
  app::note_interruptions();
  take_file_limit_for_full_disk();
  try {
    line.app.parse(argc, argv);
  } catch (const CLI::ParseError& refusal) {
    // CLI11 has its own codes for wrong usage; callers are promised 2. Help and version end with 0.
    if (line.app.exit(refusal) != 0) return 2;
  } catch (const std::exception& failure) {
    app::fail(line, {failure.what(), ""});
  }
  // An answer that did not arrive is work that was not done.
  if ((std::fflush(stdout) != 0 || !std::cout) && line.status == 0)
    app::fail(line, {std::strerror(errno), "standard output"});
  return line.status;
}
