#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <functional>
#include <string>

namespace abrazo::app {

/// A program of its own whose standard output is read; ended at the latest when it goes out of scope.
class Process {
 public:
  explicit Process(const std::function<void()>& become) {
    int ends[2];
    EXPECT_EQ(pipe2(ends, O_CLOEXEC), 0);
    pid_ = fork();
    if (pid_ == 0) {
      dup2(ends[1], STDOUT_FILENO);
      become();
      _exit(127);
    }
    close(ends[1]);
    said_ = fdopen(ends[0], "r");
  }
  ~Process() {
    end(SIGKILL);
    std::fclose(said_);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Empty at the end.
  std::string line() {
    char text[1024];
    return std::fgets(text, sizeof text, said_) ? text : "";
  }
  /// @return how it ended, as waitpid says it
  int wait() {
    int status = 0;
    if (pid_ > 0) waitpid(pid_, &status, 0);
    pid_ = -1;
    return status;
  }
  void tell(int signal) const {
    if (pid_ > 0) kill(pid_, signal);
  }
  void end(int signal) {
    if (pid_ <= 0) return;
    kill(pid_, signal);
    wait();
  }

 private:
  pid_t pid_ = -1;
  std::FILE* said_ = nullptr;
};

/// A display of its own, so that no other test's is touched.
inline void become_display() {
  execlp("Xvfb", "Xvfb", "-displayfd", "1", "-screen", "0", "1280x800x24", "-nolisten", "tcp", nullptr);
}
/// @param number  the line that the display says
inline void use_display(const std::string& number) {
  setenv("DISPLAY", (":" + number.substr(0, number.find('\n'))).c_str(), 1);
  setenv("QT_QPA_PLATFORM", "xcb", 1);
}

}  // namespace abrazo::app
