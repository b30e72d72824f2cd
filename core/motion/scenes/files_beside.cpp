#include "core/motion/scenes/files_beside.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <vector>

#include "core/base/text.hpp"

namespace abrazo {

namespace {

constexpr std::size_t most_beside_bytes = std::size_t{4} << 30U;

/// The parts of a path below a folder; nothing when it leads elsewhere.
std::vector<std::string> parts_below(std::string_view name) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t end = name.find('/');
    const std::string_view part = name.substr(0, end);
    if (part.empty() || part == ".." || part.find('\0') != std::string_view::npos) return {};
    if (part != ".") parts.emplace_back(part);
    if (end == std::string_view::npos) return parts;
    name.remove_prefix(end + 1);
  }
}

/// Reads to the end, which a file that grows meanwhile has not yet.
bool read_all(int fd, std::size_t bytes, std::string& content) {
  content.resize(bytes);
  for (std::size_t at = 0; at < bytes;) {
    const ssize_t got = ::read(fd, content.data() + at, bytes - at);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return false;
    if (got == 0) {
      content.resize(at);
      break;
    }
    at += static_cast<std::size_t>(got);
  }
  return true;
}

/// Without waiting for the other end of a pipe, and not through a link.
int open_without_following(int folder, const std::string& name, int kind) {
  int fd = -1;
  do fd = ::openat(folder, name.c_str(), kind | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  while (fd < 0 && errno == EINTR);
  return fd;
}

std::string why_not_opened() {
  if (errno == ELOOP || errno == ENOTDIR) return "is a link, or lies behind one; copy the file itself there";
  if (errno == ENOENT) return "is not there; copy it there";
  return std::string("cannot be opened (") + std::strerror(errno) + ")";
}

}  // namespace

FilesBeside::FilesBeside(const std::string& file) : file_(file), folder_(-1) {
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  folder_ = ::open(folder.empty() ? "." : folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
}

FilesBeside::~FilesBeside() {
  if (folder_ >= 0) ::close(folder_);
}

Error FilesBeside::refusal(std::string_view name, const std::string& why) const {
  return {"names the file " + in_quotes(name) + ", which " + why +
              "; or export one file that holds everything (GLB)",
          file_};
}

Result<std::string> FilesBeside::read(std::string_view name) const {
  const std::vector<std::string> parts = parts_below(name);
  if (parts.empty()) return refusal(name, "does not lie beside it; copy it there and name it without a path");
  // What is opened is held before its parent is let go.
  int folder = folder_ < 0 ? -1 : ::fcntl(folder_, F_DUPFD_CLOEXEC, 0);
  for (std::size_t p = 0; p + 1 < parts.size() && folder >= 0; ++p) {
    const int below = open_without_following(folder, parts[p], O_PATH | O_DIRECTORY);
    const int why = errno;
    ::close(folder);
    folder = below;
    errno = why;
  }
  if (folder < 0) return refusal(name, why_not_opened());
  // Looked at before it is opened: opening some devices does something.
  struct stat facts {};
  const bool is_there = ::fstatat(folder, parts.back().c_str(), &facts, AT_SYMLINK_NOFOLLOW) == 0;
  const bool may_be_read = is_there && (S_ISREG(facts.st_mode) || S_ISLNK(facts.st_mode));
  const int fd = is_there && !may_be_read ? -1 : open_without_following(folder, parts.back(), O_RDONLY);
  const std::string why = is_there && !may_be_read ? "is no file but a folder, a pipe or a device; copy the "
                                                     "file there"
                          : fd < 0                 ? why_not_opened()
                                                   : std::string();
  ::close(folder);
  if (!why.empty()) return refusal(name, why);
  std::string content;
  const bool is_file = ::fstat(fd, &facts) == 0 && S_ISREG(facts.st_mode);
  const bool fits = is_file && static_cast<std::size_t>(facts.st_size) <= most_beside_bytes;
  const bool was_read = fits && read_all(fd, static_cast<std::size_t>(facts.st_size), content);
  ::close(fd);
  if (!is_file) return refusal(name, "is no file; copy the file there");
  if (!fits) return refusal(name, "has more than 4 GB; export a shorter range");
  if (!was_read) return refusal(name, "cannot be read; check the disk");
  return content;
}

}  // namespace abrazo
