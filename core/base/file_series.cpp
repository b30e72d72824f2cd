#include "core/base/file_series.hpp"

#include <fstream>

namespace abrazo {

Status FileSeries::add(const std::string& path, const std::string& content) {
  AtomicFile& file = files_.emplace_back(path);
  std::ofstream out(file.partial(), std::ios::binary);
  out << content;
  out.close();
  if (!out) return Error{"could not be written whole; is the folder writable, the disk full?", path};
  paths_.push_back(path);
  return Done{};
}

Status FileSeries::commit() {
  for (AtomicFile& file : files_)
    if (const Status done = file.commit(); !done) return done;
  return Done{};
}

}  // namespace abrazo
