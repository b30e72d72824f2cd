#include "tests/cli/run_command.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace abrazo::test {

namespace fs = std::filesystem;

namespace {

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// What waits at our end of a terminal that nobody writes to any more.
std::string rest_of(int terminal) {
  std::string text;
  char some[4096];
  for (ssize_t count = 0; (count = ::read(terminal, some, sizeof some)) > 0;)
    text.append(some, static_cast<std::size_t>(count));
  return text;
}

}  // namespace

RunningCommand::RunningCommand(const std::vector<std::string>& words, const fs::path& folder,
                               ErrorsTo errors) {
  static int number = 0;
  const std::string mark = std::to_string(::getpid()) + "-" + std::to_string(++number);
  out_ = fs::temp_directory_path() / ("abrazo-out-" + mark);
  err_ = fs::temp_directory_path() / ("abrazo-err-" + mark);
  std::string error_sink = err_.string();
  if (errors == ErrorsTo::Terminal) {
    terminal_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (terminal_ < 0 || ::grantpt(terminal_) != 0 || ::unlockpt(terminal_) != 0)
      throw std::runtime_error("no terminal can be had");
    error_sink = ::ptsname(terminal_);
  }
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_addopen(&actions, 1, out_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::posix_spawn_file_actions_addopen(&actions, 2, error_sink.c_str(), O_WRONLY | O_CREAT | O_NOCTTY, 0600);
  ::posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  arguments.reserve(copies.size() + 1);
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const int failure = ::posix_spawn(&process_, arguments[0], &actions, nullptr, arguments.data(), ::environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) throw std::runtime_error("cannot be started: " + words.front());
}

RunningCommand::~RunningCommand() {
  if (process_ > 0) wait();
  if (terminal_ >= 0) ::close(terminal_);
  fs::remove(out_);
  fs::remove(err_);
}

void RunningCommand::signal(int number) const {
  if (process_ > 0) ::kill(process_, number);
}

bool RunningCommand::catches(int number) const {
  std::ifstream status("/proc/" + std::to_string(process_) + "/status");
  for (std::string word; status >> word;)
    if (word == "SigCgt:") {
      unsigned long long mask = 0;
      status >> std::hex >> mask;
      return (mask >> (number - 1) & 1U) != 0;
    }
  return false;
}

pid_t RunningCommand::child(const std::string& name) const {
  const std::string number = std::to_string(process_);
  std::ifstream children("/proc/" + number + "/task/" + number + "/children");
  for (pid_t child = 0; children >> child;)
    if (content_of("/proc/" + std::to_string(child) + "/comm") == name + "\n") return child;
  return -1;
}

bool RunningCommand::finished() {
  if (process_ > 0 && ::waitpid(process_, &wait_status_, WNOHANG) == process_) process_ = -1;
  return process_ < 0;
}

Outcome RunningCommand::wait() {
  if (process_ > 0) ::waitpid(process_, &wait_status_, 0);
  process_ = -1;
  Outcome outcome;
  outcome.status = WIFEXITED(wait_status_) ? WEXITSTATUS(wait_status_) : 128 + WTERMSIG(wait_status_);
  outcome.out = content_of(out_);
  outcome.err = terminal_ >= 0 ? rest_of(terminal_) : content_of(err_);
  return outcome;
}

std::string RunningCommand::answers_so_far() const {
  return content_of(out_);
}

std::string RunningCommand::errors_so_far() const {
  return content_of(err_);
}

Outcome run_abrazo(const fs::path& folder, std::vector<std::string> words) {
  words.insert(words.begin(), ABRAZO_PROGRAM);
  return RunningCommand(words, folder).wait();
}

bool can_open_terminal() {
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (terminal < 0) return false;
  const bool usable = ::grantpt(terminal) == 0 && ::unlockpt(terminal) == 0;
  const char* name = usable ? ::ptsname(terminal) : nullptr;
  const bool exists = name != nullptr && ::access(name, R_OK | W_OK) == 0;
  ::close(terminal);
  return exists;
}

}  // namespace abrazo::test
