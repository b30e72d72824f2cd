#include "core/base/watched_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <utility>

namespace abrazo {

// O_PATH opens the name alone: closing such a descriptor drops none of the process's locks on the file, which
// SQLite needs.
WatchedFile::WatchedFile(std::string path)
    : path_(std::move(path)), descriptor_(::open(path_.c_str(), O_PATH | O_CLOEXEC)) {}

WatchedFile::WatchedFile(WatchedFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

WatchedFile& WatchedFile::operator=(WatchedFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

WatchedFile::~WatchedFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

WatchedFile::State WatchedFile::state() const {
  struct stat own {
  }, named{};
  if (descriptor_ < 0 || ::fstat(descriptor_, &own) != 0 || own.st_nlink == 0) return State::Deleted;
  const bool is_same =
      ::stat(path_.c_str(), &named) == 0 && named.st_dev == own.st_dev && named.st_ino == own.st_ino;
  return is_same ? State::There : State::Moved;
}

std::optional<std::int64_t> WatchedFile::written_ns() const {
  struct stat own {};
  if (descriptor_ < 0 || ::fstat(descriptor_, &own) != 0) return std::nullopt;
  return std::int64_t{own.st_mtim.tv_sec} * 1'000'000'000 + own.st_mtim.tv_nsec;
}

}  // namespace abrazo
