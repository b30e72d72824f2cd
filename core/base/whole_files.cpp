#include "core/base/whole_files.hpp"

namespace abrazo {

Status WholeFiles::add(const std::string& file, std::string_view content) {
  return files_.emplace_back(file).write(content);
}

Status WholeFiles::commit() {
  for (AtomicFile& file : files_)
    if (const Status named = file.commit(); !named) return named;
  return Done{};
}

}  // namespace abrazo
