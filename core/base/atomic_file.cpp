#include "core/base/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <random>

#include "core/base/available_memory.hpp"

namespace abrazo {

namespace fs = std::filesystem;

namespace {

/// Number of attempts to draw an unused name; a name of 62 bits is never taken by accident.
constexpr int most_draws = 100;

std::string unforeseeable_text() {
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz0123456789";
  std::random_device device;  // of the system: another program cannot tell what comes next
  std::uniform_int_distribution<std::size_t> one(0, letters.size() - 1);
  std::string text;
  for (int i = 0; i < 12; ++i) text += letters[one(device)];
  return text;
}

/// Who may write in the folder may have put a link in its place meanwhile.
bool is_one_file(const struct stat& status) {
  return S_ISREG(status.st_mode) && status.st_nlink <= 1;
}

Error was_swapped(const fs::path& target) {
  return {
      "was not written: another program put something in the place of its partial file; choose a folder "
      "that only you may write to",
      target.string()};
}

bool write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

Status check_replaceable(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return Done{};
  // Whoever is root may write it all the same, and did not mean to.
  if ((status.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) != 0 && ::access(path.c_str(), W_OK) == 0)
    return Done{};
  return Error{"is write-protected; change its permissions, or choose another name", path.string()};
}

bool make_new_file(const fs::path& path) {
  // Who may read it is up to the umask, as with any file.
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor < 0) return false;
  ::close(descriptor);
  return true;
}

AtomicFile::AtomicFile(fs::path target, std::string_view extension) : target_(std::move(target)) {
  for (int draw = 0; draw < most_draws; ++draw) {
    partial_ = target_.string() + ".partial-" + unforeseeable_text() + std::string(extension);
    if (make_new_file(partial_) || errno != EEXIST) return;
  }
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!committed_) fs::remove(partial_, ignored);
}

Status AtomicFile::commit() {
  std::error_code failure;
  struct stat status {};
  if (::lstat(partial_.c_str(), &status) == 0 && !is_one_file(status)) return was_swapped(target_);
  if (const fs::file_status old = fs::symlink_status(target_, failure); fs::is_regular_file(old)) {
    if (const Status replaceable = check_replaceable(target_); !replaceable) return replaceable;
    fs::permissions(partial_, old.permissions(), failure);
  }
  fs::rename(partial_, target_, failure);
  if (failure) return Error{"could not be written: " + failure.message(), target_.string()};
  committed_ = true;
  return Done{};
}

Status AtomicFile::write(std::string_view content) const {
  const int descriptor = ::open(partial_.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0)
    return Error{std::string("cannot be created: ") + std::strerror(errno) +
                     "; choose a folder that exists and can be written",
                 target_.string()};
  struct stat status {};
  const bool is_ours = ::fstat(descriptor, &status) == 0 && is_one_file(status);
  const bool is_whole = is_ours && ::ftruncate(descriptor, 0) == 0 && write_all(descriptor, content);
  if (::close(descriptor) == 0 && is_whole) return Done{};
  return is_ours ? Error{"could not be written whole; is the disk full?", target_.string()}
                 : was_swapped(target_);
}

Status write_whole_file(const fs::path& target, std::string_view content) {
  AtomicFile file(target);
  if (const Status written = file.write(content); !written) return written.error();
  return file.commit();
}

Result<std::string> read_whole_file(const fs::path& path, std::uintmax_t most_bytes) {
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (fs::is_directory(status)) return Error{"is a folder; name a file", path.string()};
  // Opening a pipe may wait forever, and a device may have no end.
  if (fs::exists(status) && !fs::is_regular_file(status))
    return Error{"is a device or a pipe; name a file", path.string()};
  const std::uintmax_t bytes = fs::file_size(path, failure);
  if (!failure && bytes > most_bytes)
    return Error{"is " + std::to_string(bytes >> 20U) + " MB large; files of this kind are read up to " +
                     std::to_string(most_bytes >> 20U) + " MB. Split it",
                 path.string()};
  if (const std::uint64_t free = available_memory_bytes(); !failure && bytes > free / 2)
    return Error{"is " + std::to_string(bytes >> 20U) + " MB large, and " + std::to_string(free >> 20U) +
                     " MB of memory are free; close other programs, or split it",
                 path.string()};
  std::ifstream in(path, std::ios::binary);
  if (!in) return Error{std::string("cannot be opened: ") + std::strerror(errno), path.string()};
  std::string content(failure ? 0 : static_cast<std::size_t>(bytes), '\0');
  in.read(content.data(), static_cast<std::streamsize>(content.size()));
  content.resize(static_cast<std::size_t>(in.gcount()));
  content.append(std::istreambuf_iterator<char>(in), {});  // what was written meanwhile
  if (content.starts_with("version https://git-lfs.github.com/spec/"))
    return Error{"is a Git LFS pointer in place of the file: run git lfs pull where it was cloned",
                 path.string()};
  return content;
}

}  // namespace abrazo
