#pragma once

#include <QSize>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace abrazo::app {

/// What the program was asked for.
struct CommandLine {
  std::vector<std::string> files;
  bool demo = false;
  std::string library;
  std::string settings;           ///< a JSON file, or the object itself
  std::string session;            ///< a recorded one
  std::string listen;             ///< URI of a live stream
  std::vector<std::string> send;  ///< URIs that the partner is sent to
  std::string screenshot;         ///< where to write one picture of the window
  std::string record;             ///< folder for a picture, a video and the motion
  double after_s = 3;             ///< counted from the first frame shown
  int smoke_frames = 0;
  bool start_times = false;   ///< tell how long the start took, then quit
  double status_every_s = 0;  ///< a line of figures so often; 0 = never
  std::string theme;
  QSize size;

  /// The program shows something by itself and quits.
  bool unattended() const {
    return !screenshot.empty() || !record.empty() || smoke_frames > 0 || start_times;
  }
};

/// The program is not to start: with this exit status, after what was printed.
struct ExitStatus {
  int code = 0;
};

std::variant<CommandLine, ExitStatus> parse_command_line(int argc, char** argv);

}  // namespace abrazo::app
