#pragma once

#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo::app {

/// A child process. The destructor terminates it (SIGTERM) and waits; the system ends it if this process dies
/// first.
class ChildProcess {
 public:
  struct Start {
    std::vector<std::string> words;        ///< the program, found along PATH, and its arguments
    std::vector<std::string> environment;  ///< "NAME=value", over those of this process
    int kept_fd = -1;                      ///< file descriptor inherited under the same number
    bool is_apart = false;                 ///< does not receive Ctrl-C from the terminal
    bool is_silent = false;                ///< its output is discarded
  };
  static Result<ChildProcess> start(const Start& start);
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;
  ~ChildProcess();

  /// Forwards SIGTERM if this process is to end. @return its exit status; 128 + signal if it was killed
  int wait();

 private:
  explicit ChildProcess(int pid) : pid_(pid) {}
  int pid_;  ///< -1 after waiting
};

}  // namespace abrazo::app
