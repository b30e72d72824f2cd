#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace abrazo::test {

/// What a finished command left.
struct Outcome {
  int status = -1;  ///< exit status; 128 + signal when a signal ended it
  std::string out, err;
};

/// A program that runs in `folder`, without input. Waited for at the latest when it goes out of scope.
class RunningCommand {
 public:
  enum class ErrorsTo { File, Terminal };

  RunningCommand(const std::vector<std::string>& words, const std::filesystem::path& folder,
                 ErrorsTo errors = ErrorsTo::File);
  ~RunningCommand();
  RunningCommand(const RunningCommand&) = delete;
  RunningCommand& operator=(const RunningCommand&) = delete;

  void signal(int number) const;
  /// The running program has a handler of its own for this signal.
  bool catches(int number) const;
  /// The process of this name that it started; none: -1. Linux cuts names after 15 characters.
  pid_t child(const std::string& name) const;
  bool finished();
  Outcome wait();
  /// What it has written by now; of errors only those that go to a file.
  std::string answers_so_far() const;
  std::string errors_so_far() const;

 private:
  std::filesystem::path out_, err_;
  int terminal_ = -1;  ///< our end of the terminal that the program's errors go to
  pid_t process_ = -1;
  int wait_status_ = 0;
};

/// Whether the system gives out pseudo-terminals (a bare chroot does not).
bool can_open_terminal();

/// Runs `abrazo` with these words to its end.
Outcome run_abrazo(const std::filesystem::path& folder, std::vector<std::string> words);

}  // namespace abrazo::test
