#include "core/motion/scenes/helper_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <utility>

namespace abrazo {

namespace {

using HelperClock = std::chrono::steady_clock;
constexpr int between_looks_ms = 20;
constexpr std::size_t piece_bytes = 1U << 20U;

/// An open file of this process, closed with it.
class OwnedFile {
 public:
  explicit OwnedFile(int fd) : fd_(fd) {}
  OwnedFile(const OwnedFile&) = delete;
  OwnedFile& operator=(const OwnedFile&) = delete;
  ~OwnedFile() { close(); }
  int get() const { return fd_; }
  void close() {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
  }

 private:
  int fd_;
};

/// Killed when it goes out of scope, unless it has ended.
class RunningHelper {
 public:
  explicit RunningHelper(pid_t pid) : pid_(pid) {}
  RunningHelper(const RunningHelper&) = delete;
  RunningHelper& operator=(const RunningHelper&) = delete;
  ~RunningHelper() {
    if (pid_ < 0) return;
    ::kill(pid_, SIGKILL);
    while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }

  /// Waits for the end of a helper that has closed its output. The end is unknown if the host application
  /// lets the system collect its child processes.
  HelperAnswer end(HelperClock::time_point deadline) {
    while (HelperClock::now() < deadline) {
      int status = 0;
      const pid_t done = ::waitpid(pid_, &status, WNOHANG);
      if (done == 0 || (done < 0 && errno == EINTR)) {
        ::poll(nullptr, 0, 1);
        continue;
      }
      pid_ = -1;
      if (done < 0) return {HelperAnswer::End::Unknown, 0, {}};
      if (WIFSIGNALED(status)) return {HelperAnswer::End::Signal, WTERMSIG(status), {}};
      return {HelperAnswer::End::Exit, WEXITSTATUS(status), {}};
    }
    return {HelperAnswer::End::TooLong, 0, {}};
  }

 private:
  pid_t pid_;
};

Error not_started(const HelperJob& job, int why) {
  return Error{"cannot be started (" + std::string(std::strerror(why)) + ")", job.program.string()};
}

/// Writes the input to an anonymous file. @return whether all of it was written
bool fill_input(int fd, std::string_view input) {
  while (!input.empty()) {
    const ssize_t wrote = ::write(fd, input.data(), std::min<std::size_t>(input.size(), 1U << 30U));
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote <= 0) return false;
    input.remove_prefix(static_cast<std::size_t>(wrote));
  }
  return ::lseek(fd, 0, SEEK_SET) == 0;
}

/// @return 0, or why it cannot be started
int start_program(const HelperJob& job, int input, int output, pid_t& pid) {
  std::vector<std::string> words = {job.program.string()};
  words.insert(words.end(), job.arguments.begin(), job.arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&files);
  ::posix_spawnattr_init(&attributes);
  ::posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // whose reports somebody has to see
  ::posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
#endif
  ::posix_spawn_file_actions_addclosefrom_np(&files, STDERR_FILENO + 1);
  sigset_t none, all;
  ::sigemptyset(&none);
  ::sigfillset(&all);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setsigdefault(&attributes, &all);
  ::posix_spawnattr_setpgroup(&attributes, 0);
  ::posix_spawnattr_setflags(&attributes,
                             POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  const int why = ::posix_spawn(&pid, words.front().c_str(), &files, &attributes, pointers.data(), environ);
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&files);
  return why;
}

}  // namespace

Result<HelperAnswer> run_helper(const HelperJob& job, const Progress& progress) {
  if (!report(progress, 0, job.doing)) return Error{"cancelled", {}};
  OwnedFile input(::memfd_create("abrazo-input", MFD_CLOEXEC));
  if (input.get() < 0 || !fill_input(input.get(), job.input)) return not_started(job, errno);
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return not_started(job, errno);
  OwnedFile answer(ends[0]), written(ends[1]);
  ::fcntl(answer.get(), F_SETPIPE_SZ, static_cast<int>(piece_bytes));  // faster where it is allowed
  pid_t pid = -1;
  if (const int why = start_program(job, input.get(), written.get(), pid); why != 0)
    return not_started(job, why);
  RunningHelper helper(pid);
  written.close();
  input.close();

  const auto deadline = HelperClock::now() + std::chrono::duration_cast<HelperClock::duration>(
                                                 std::chrono::duration<double>(job.patience_s));
  std::string bytes, piece(piece_bytes, '\0');
  while (true) {
    if (HelperClock::now() > deadline) return HelperAnswer{HelperAnswer::End::TooLong, 0, {}};
    pollfd ready{answer.get(), POLLIN, 0};
    const int found = ::poll(&ready, 1, between_looks_ms);
    if (!report(progress, 0, job.doing)) return Error{"cancelled", {}};
    if (found <= 0) continue;
    const ssize_t got = ::read(answer.get(), piece.data(), piece.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    if (static_cast<std::size_t>(got) > job.most_bytes - bytes.size())
      return HelperAnswer{HelperAnswer::End::TooMuch, 0, {}};
    bytes.append(piece, 0, static_cast<std::size_t>(got));
  }
  HelperAnswer end = helper.end(deadline);
  end.bytes = std::move(bytes);
  return end;
}

}  // namespace abrazo
