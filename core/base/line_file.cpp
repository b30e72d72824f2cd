#include "core/base/line_file.hpp"

namespace abrazo {

LineFile::LineFile(const std::string& path)
    : path_(path), file_(path), out_(file_.partial(), std::ios::binary) {}

Result<std::unique_ptr<LineFile>> LineFile::open(const std::string& path) {
  auto file = std::unique_ptr<LineFile>(new LineFile(path));
  if (!file->out_) return Error{"cannot be created; choose a folder that exists and can be written", path};
  return file;
}

Status LineFile::close() {
  if (out_.is_open()) out_.close();
  if (!out_) return Error{"could not be written whole; is the disk full?", path_};
  return Done{};
}

Status LineFile::finish() {
  if (const Status closed = close(); !closed) return closed;
  return file_.commit();
}

}  // namespace abrazo
