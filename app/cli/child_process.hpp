#pragma once

#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo::app {

/// A program that was started; ended (SIGTERM) and waited for when it goes out of scope, and by the system
/// when this one dies first.
class ChildProcess {
 public:
  struct Start {
    std::vector<std::string> words;        ///< the program, found along PATH, and its arguments
    std::vector<std::string> environment;  ///< "NAME=value", over those of this process
    int kept_fd = -1;                      ///< stays open for it under the same number
    bool is_apart = false;                 ///< Ctrl-C in the terminal does not reach it
    bool is_silent = false;                ///< what it prints goes nowhere
  };
  static Result<ChildProcess> start(const Start& start);
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;
  ~ChildProcess();

  /// Passes SIGTERM on when this process was asked to end. @return its exit status; 128 + signal when it was
  /// killed
  int wait();

 private:
  explicit ChildProcess(int pid) : pid_(pid) {}
  int pid_;  ///< -1 when it has been waited for
};

}  // namespace abrazo::app
