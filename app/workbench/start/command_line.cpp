#include "app/workbench/start/command_line.hpp"

#include <CLI/CLI.hpp>
#include <iostream>

#include "core/base/printable.hpp"
#include "core/base/text.hpp"
#include "core/base/version.hpp"
#include "core/stream/protocol/stream_uri.hpp"

namespace abrazo::app {
namespace {

std::string read_size(const std::string& text, QSize& size) {
  const auto parts = split_fields(text, 'x');
  const auto width = parts.size() == 2 ? parse_integer(parts[0]) : std::nullopt;
  const auto height = parts.size() == 2 ? parse_integer(parts[1]) : std::nullopt;
  if (!width || !height || *width < 640 || *height < 400 || *width > 16384 || *height > 16384)
    return "write a size as 1600x1000, at least 640x400";
  size = QSize(static_cast<int>(*width), static_cast<int>(*height));
  return {};
}

/// What is wrong with a stream's URI; nothing when it is one.
std::string wrong_uri(const std::string& text) {
  const auto uri = parse_stream_uri(text);
  return uri ? std::string() : uri.error().text();
}

}  // namespace

std::variant<CommandLine, ExitStatus> parse_command_line(int argc, char** argv) {
  CommandLine asked;
  std::string size;
  CLI::App parser("Abrazo: a workbench for partner control in close interactions", "abrazo-workbench");
  parser.set_version_flag("--version", std::string("abrazo-workbench ") + version());
  auto* files = parser.add_option("FILE", asked.files,
                                  "motion (.bvh, .amc; also its .asf or joint map), library (.h5), manifest "
                                  "(.json) or session (.abrazo) to open");
  auto* library = parser.add_option("--library", asked.library, "library (.h5) or manifest (.json)");
  parser.add_flag("--demo", asked.demo, "the generated dance; also the default without any file")
      ->excludes(files)
      ->excludes(library);
  parser
      .add_option("--listen", asked.listen,
                  "live stream to follow: vmc://HOST:PORT, natnet://HOST[:PORT][?multicast=GROUP], "
                  "xsens://HOST:PORT")
      ->check(wrong_uri);
  parser.add_option("--send", asked.send, "where to send the partner, such as vmc://127.0.0.1:39540")
      ->check(wrong_uri);
  parser.add_option("--session", asked.session, "recorded session (.abrazo) to open");
  parser.add_option("--settings", asked.settings, "settings: a JSON file, or the JSON object itself");
  parser.add_option("--screenshot", asked.screenshot, "write a picture of the window here, then quit");
  parser.add_option("--record", asked.record,
                    "write a picture, a video and the motion into this folder, then quit");
  parser
      .add_option("--after", asked.after_s,
                  "seconds from the first frame to the picture or the end of the recording")
      ->check(CLI::Range(0.0, 3600.0));
  parser.add_option("--smoke", asked.smoke_frames, "show this many solved frames, then quit")
      ->check(CLI::Range(1, 1000000));
  parser.add_flag(
      "--start-times", asked.start_times,
      "print when each stage of the start was reached, up to the first moving picture, then quit");
  parser
      .add_option("--status-every", asked.status_every_s,
                  "write a line of figures (JSON) to the output at this interval in seconds")
      ->check(CLI::Range(0.1, 3600.0));
  parser.add_option("--theme", asked.theme, "dark or light")->check(CLI::IsMember({"dark", "light"}));
  parser.add_option("--size", size, "size of the window, such as 1600x1000")
      ->check([&asked](const std::string& text) { return read_size(text, asked.size); });
  parser.failure_message([](const CLI::App*, const CLI::Error& error) {
    return "abrazo-workbench: " + printable_line(error.what()) + "; see abrazo-workbench --help\n";
  });
  try {
    parser.parse(argc, argv);
  } catch (const CLI::ParseError& stop) {
    return ExitStatus{parser.exit(stop) == 0 ? 0 : 2};
  }
  return asked;
}

}  // namespace abrazo::app
