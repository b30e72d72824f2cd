#include "app/cli/child_process.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

#include "app/cli/interruption.hpp"

namespace abrazo::app {
namespace {

constexpr auto between_looks = std::chrono::milliseconds(20);

/// In the child, between fork and exec: only what may be called there.
void set_up(const ChildProcess::Start& start) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (start.is_apart) ::setsid();
  if (start.kept_fd >= 0) ::fcntl(start.kept_fd, F_SETFD, 0);
  if (!start.is_silent) return;
  const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, fd);
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

std::vector<std::string> environment_with(const std::vector<std::string>& changes) {
  std::vector<std::string> result = changes;
  for (char** entry = environ; entry && *entry; ++entry) {
    const std::string text = *entry;
    const std::string name = text.substr(0, text.find('=') + 1);
    bool is_changed = false;
    for (const std::string& change : changes) is_changed |= change.starts_with(name);
    if (!is_changed) result.push_back(text);
  }
  return result;
}

}  // namespace

Result<ChildProcess> ChildProcess::start(const Start& start) {
  std::vector<std::string> words = start.words, environment = environment_with(start.environment);
  const std::vector<char*> arguments = pointers(words), variables = pointers(environment);
  std::array<int, 2> failure{};  // closes with exec; else has why it failed
  if (::pipe2(failure.data(), O_CLOEXEC) != 0) return Error{std::strerror(errno), start.words.front()};
  const int pid = ::fork();
  if (pid == 0) {
    set_up(start);
    ::execvpe(arguments[0], arguments.data(), variables.data());
    const int why = errno;
    if (::write(failure[1], &why, sizeof why) < 0) ::_exit(126);
    ::_exit(127);
  }
  ::close(failure[1]);
  int why = pid < 0 ? errno : 0;
  if (pid > 0 && ::read(failure[0], &why, sizeof why) != static_cast<ssize_t>(sizeof why)) why = 0;
  ::close(failure[0]);
  if (why == 0) return ChildProcess(pid);
  if (pid > 0) ::waitpid(pid, nullptr, 0);
  return Error{std::strerror(why), start.words.front()};
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept : pid_(other.pid_) {
  other.pid_ = -1;
}

ChildProcess::~ChildProcess() {
  if (pid_ < 0) return;
  ::kill(pid_, SIGTERM);
  ::waitpid(pid_, nullptr, 0);
}

int ChildProcess::wait() {
  bool was_told = false;
  int status = 0;
  for (int done = 0; done == 0;) {
    done = ::waitpid(pid_, &status, WNOHANG);
    if (done < 0 && errno != EINTR) break;
    if (done < 0) done = 0;
    if (done == 0 && interrupted() && !was_told) {
      ::kill(pid_, SIGTERM);  // it handles the first signal and stops properly, even if it got another one
      was_told = true;
    }
    if (done == 0) std::this_thread::sleep_for(between_looks);
  }
  pid_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + (WIFSIGNALED(status) ? WTERMSIG(status) : 0);
}

}  // namespace abrazo::app
