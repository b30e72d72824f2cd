#include "core/base/atomic_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

namespace abrazo {

namespace fs = std::filesystem;

AtomicFile::AtomicFile(fs::path target)
    : target_(std::move(target)), partial_(target_.string() + ".partial-" + std::to_string(::getpid())) {}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!committed_) fs::remove(partial_, ignored);
}

Status AtomicFile::commit() {
  std::error_code failure;
  fs::rename(partial_, target_, failure);
  if (failure) return Error{"could not be written: " + failure.message(), target_.string()};
  committed_ = true;
  return Done{};
}

Status write_whole_file(const fs::path& target, std::string_view content) {
  AtomicFile file(target);
  std::ofstream out(file.partial(), std::ios::binary);
  if (!out)
    return Error{std::string("cannot be created: ") + std::strerror(errno) +
                     "; choose a folder that exists and can be written",
                 target.string()};
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  if (!out) return Error{"could not be written whole; is the disk full?", target.string()};
  return file.commit();
}

Result<std::string> read_whole_file(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return Error{"is a folder; name a file", path.string()};
  std::ifstream in(path, std::ios::binary);
  if (!in) return Error{std::string("cannot be opened: ") + std::strerror(errno), path.string()};
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

}  // namespace abrazo
