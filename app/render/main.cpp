// Draws recorded frames without a window: the part of `abrazo render` that needs Qt and VTK.
#include <fmt/format.h>

#include <QApplication>
#include <clocale>
#include <cstdio>

#include "app/cli/command_line.hpp"
#include "app/cli/interruption.hpp"
#include "app/render/frame_source.hpp"
#include "app/render/rendering.hpp"
#include "core/base/file_limit.hpp"
#include "core/base/output_file.hpp"
#include "core/base/printable.hpp"
#include "core/base/version.hpp"

namespace abrazo::app {
namespace {

void pass_on_fatal_only(QtMsgType type, const QMessageLogContext&, const QString& text) {
  if (type == QtFatalMsg) std::fprintf(stderr, "abrazo: %s\n", printable(text.toStdString()).c_str());
}

Status run(CommandLine& line, const RenderOptions& options) {
  if (const Status usable = check_render(options); !usable) return usable;
  if (const Status usable = check_output(options.output, inputs_of(options)); !usable) return usable;
  const Progress progress = terminal_progress(line);
  auto source = open_frames(options.input, options.library, progress);
  if (!source) return source.error();
  for (const std::string& warning : source->warnings) warn(line, warning);
  const auto rendered = render(*source, options, progress);
  if (!rendered) return rendered.error();
  if (!line.quiet)
    answer(line, fmt::format("{}: {} picture{}, {}\n", rendered->file, rendered->pictures,
                             rendered->pictures == 1 ? "" : "s", options.size));
  return Done{};
}

}  // namespace
}  // namespace abrazo::app

int main(int argc, char** argv) {
  using namespace abrazo;
  app::CommandLine line;
  app::RenderOptions options;
  line.app.name("abrazo-render");
  line.app.set_version_flag("--version", std::string("abrazo-render ") + version());
  line.app.add_flag("--quiet", line.quiet, "no progress, warnings or summary");
  app::add_render_options(line.app, options);
  line.app.failure_message(app::usage_message);
  try {
    line.app.parse(argc, argv);
  } catch (const CLI::ParseError& refusal) {
    return line.app.exit(refusal) != 0 ? 2 : 0;
  }
  app::note_interruptions_of_child();
  take_file_limit_for_full_disk();
  qInstallMessageHandler(app::pass_on_fatal_only);
  int words = 1;  // the toolkit's own options are none of this program's
  QApplication application(words, argv);
  std::setlocale(LC_NUMERIC, "C");
  if (const Status done = app::run(line, options); !done) app::fail(line, done.error());
  return line.status;
}
