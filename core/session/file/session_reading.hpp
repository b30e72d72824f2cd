#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/session/file/session_file.hpp"

namespace abrazo {

/// The libraries of a session file: the one that was given when it fits, else where the session says.
class SessionLibraries {
 public:
  /// @param given  path of a library that takes the place of those of the session; empty = none
  SessionLibraries(std::shared_ptr<const SessionFile> file, std::string given)
      : file_(std::move(file)), given_(std::move(given)) {}

  struct Opened {
    std::shared_ptr<const MotionLibrary> library;
    std::string path;
  };
  /// The library of a part; the Error says how to give one.
  Result<Opened> open(const SessionLibrary* reference);

  /// All of them in their order, each once, with a warning for each that is not at hand or was never a file.
  /// The given one comes in any case, with a warning where it is none of them.
  /// @return an Error when the given one cannot be read
  Result<std::vector<std::shared_ptr<const MotionLibrary>>> all(std::vector<std::string>& warnings) const;

 private:
  std::shared_ptr<const SessionFile> file_;
  std::string given_;
  Opened last_;
  const SessionLibrary* last_reference_ = nullptr;
};

}  // namespace abrazo
