#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <memory>

#include "app/cli/command_line.hpp"
#include "app/cli/interruption.hpp"
#include "app/cli/virtual_display.hpp"
#include "app/render/render_options.hpp"
#include "core/base/output_file.hpp"

namespace abrazo::app {
namespace {

/// The drawing program is beside this one, which links no toolkit and therefore starts quickly.
Result<std::string> renderer() {
  std::error_code failure;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", failure);
  const std::filesystem::path beside = self.parent_path() / "abrazo-render";
  if (!failure && ::access(beside.c_str(), X_OK) == 0) return beside.string();
  return Error{
      "is missing: the drawing program comes with the workbench; build Abrazo with "
      "ABRAZO_WORKBENCH=ON",
      beside.string()};
}

bool has_display() {
  const char* display = std::getenv("DISPLAY");
  return display && *display;
}

Result<int> run(const RenderOptions& options, bool quiet) {
  if (const Status usable = check_render(options); !usable) return usable.error();
  if (const Status usable = check_output(options.output, inputs_of(options)); !usable) return usable.error();
  const auto program = renderer();
  if (!program) return program.error();
  ChildProcess::Start start;
  start.words = {*program};
  if (quiet) start.words.push_back("--quiet");
  for (const std::string& word : words_of(options)) start.words.push_back(word);
  std::unique_ptr<VirtualDisplay> display;
  if (!has_display()) {
    auto made = VirtualDisplay::start();
    if (!made) return made.error();
    display = std::make_unique<VirtualDisplay>(std::move(made).value());
    start.environment = {"DISPLAY=" + display->name(), "QT_QPA_PLATFORM=xcb"};
  }
  leave_second_signal_to_child();
  auto drawing = ChildProcess::start(start);
  if (!drawing) return drawing.error();
  const int status = drawing->wait();
  if (status <= 2) return status;
  return Error{
      "the drawing ended without an answer (status " + std::to_string(status) +
          "): the display may be missing, or has no OpenGL 3.2; unset DISPLAY to draw on one in memory",
      *program};
}

}  // namespace

void add_render_command(CommandLine& line) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = line.app.add_subcommand(
      "render", "pictures or a film of a recorded session or of a trace; needs no display");
  add_render_options(*command, *options);
  command->callback([&line, options] {
    const auto status = run(*options, line.quiet);
    if (!status) return fail(line, status.error());
    line.status = *status;
  });
}

}  // namespace abrazo::app
