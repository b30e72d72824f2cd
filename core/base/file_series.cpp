#include "core/base/file_series.hpp"

#include <filesystem>

namespace abrazo {

namespace fs = std::filesystem;

Status FileSeries::add(const std::string& path, const std::string& content) {
  if (const Status written = files_.emplace_back(path).write(content); !written) return written;
  paths_.push_back(path);
  return Done{};
}

Status FileSeries::commit() {
  std::error_code ignored;
  for (const std::string& path : paths_)
    if (fs::is_directory(path, ignored))
      return Error{"is a folder; choose another name, nothing was written", path};
  std::vector<std::string> added;
  std::size_t replaced = 0;
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    const bool is_new = !fs::exists(paths_[i], ignored);
    if (Status done = files_[i].commit(); !done) {
      for (const std::string& path : added) fs::remove(path, ignored);
      if (replaced == 0) return done;
      return Error{done.error().message + "; " + std::to_string(replaced) +
                       (replaced == 1 ? " older file of the series was" : " older files of the series were") +
                       " already replaced",
                   done.error().where};
    }
    if (is_new)
      added.push_back(paths_[i]);
    else
      ++replaced;
  }
  return Done{};
}

}  // namespace abrazo
