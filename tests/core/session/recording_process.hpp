#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

namespace abrazo::test {

inline double monotonic_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// recording_victim.cpp as a process of its own, and what it said of the frames that it handed over.
class RecordingProcess {
 public:
  struct Line {
    std::uint64_t index = 0;
    double time_s = 0, handed_over_s = 0;
    std::uint64_t on_disk = 0;
    double behind_s = 0;
  };

  explicit RecordingProcess(const std::string& path) {
    int ends[2];
    EXPECT_EQ(pipe2(ends, O_CLOEXEC), 0);
    child_ = fork();
    if (child_ == 0) {
      dup2(ends[1], STDOUT_FILENO);
      execl(ABRAZO_VICTIM, ABRAZO_VICTIM, path.c_str(), nullptr);
      _exit(127);
    }
    close(ends[1]);
    said_ = fdopen(ends[0], "r");
  }
  ~RecordingProcess() { kill_it(); }
  RecordingProcess(const RecordingProcess&) = delete;
  RecordingProcess& operator=(const RecordingProcess&) = delete;

  const std::vector<Line>& lines() const { return lines_; }
  /// Waits till it has handed over so many frames.
  bool read_until(std::size_t frames) {
    while (lines_.size() < frames && take()) continue;
    return lines_.size() >= frames;
  }
  /// It does nothing more till it is woken.
  bool put_to_sleep() {
    kill(child_, SIGSTOP);
    int status = 0;
    return waitpid(child_, &status, WUNTRACED) == child_ && WIFSTOPPED(status);
  }
  void wake() { kill(child_, SIGCONT); }
  /// Without any warning. @return when
  double kill_it() {
    if (child_ < 0) return 0;
    const double now_s = monotonic_s();
    kill(child_, SIGKILL);
    while (take()) continue;  // what it still said
    std::fclose(said_);
    int status = 0;
    waitpid(child_, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status)) << "it ended by itself";
    child_ = -1;
    return now_s;
  }

 private:
  bool take() {
    char text[256];
    if (!std::fgets(text, sizeof text, said_)) return false;
    Line line;
    std::istringstream(text) >> line.index >> line.time_s >> line.handed_over_s >> line.on_disk >>
        line.behind_s;
    lines_.push_back(line);
    return true;
  }

  pid_t child_ = -1;
  std::FILE* said_ = nullptr;
  std::vector<Line> lines_;
};

}  // namespace abrazo::test
