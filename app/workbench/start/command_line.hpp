#pragma once

#include <QSize>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace abrazo::app {

/// Options of the program.
struct CommandLine {
  std::vector<std::string> files;
  bool demo = false;
  std::string library;
  std::string settings;           ///< a JSON file, or the object itself
  std::string session;            ///< file of a recorded session
  std::string listen;             ///< URI of a live stream
  std::vector<std::string> send;  ///< URIs of sinks for the partner
  std::string screenshot;         ///< file of a screenshot
  std::string record;             ///< folder for a picture, a video and the motion
  double after_s = 3;             ///< counted from the first frame shown
  int smoke_frames = 0;
  bool start_times = false;   ///< print the times of the start, then quit
  double status_every_s = 0;  ///< interval of a line of figures; 0 = never
  std::string theme;
  QSize size;

  /// Whether the program runs without a user and then quits.
  bool unattended() const {
    return !screenshot.empty() || !record.empty() || smoke_frames > 0 || start_times;
  }
};

/// The program should end with this exit status, after printed output.
struct ExitStatus {
  int code = 0;
};

std::variant<CommandLine, ExitStatus> parse_command_line(int argc, char** argv);

}  // namespace abrazo::app
