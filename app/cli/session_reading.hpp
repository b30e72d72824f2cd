#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/cli/command_line.hpp"
#include "core/library/motion_library.hpp"
#include "core/session/session_export.hpp"

namespace abrazo::app {

/// Opens a session file; what a crash did to it, or that it is still being recorded, is said as a warning.
Result<std::shared_ptr<const SessionFile>> open_session(CommandLine& line, const std::string& path);

/// The libraries of a session: the one that was given when it fits, else where the session says.
class SessionLibraries {
 public:
  /// @param given  path of a library that takes the place of those of the session; empty = none
  SessionLibraries(const SessionFile& file, std::string given) : file_(file), given_(std::move(given)) {}

  struct Opened {
    std::shared_ptr<const MotionLibrary> library;
    std::string path;
  };
  /// The library of a part; the Error says how to give one.
  Result<Opened> open(const SessionLibrary* reference);

 private:
  const SessionFile& file_;
  std::string given_;
  Opened last_;
  const SessionLibrary* last_reference_ = nullptr;
};

}  // namespace abrazo::app
