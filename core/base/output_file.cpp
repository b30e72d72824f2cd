#include "core/base/output_file.hpp"

#include <filesystem>

namespace abrazo {

namespace fs = std::filesystem;

Status check_output(const std::string& path, const std::vector<std::string>& inputs) {
  std::error_code ignored;
  if (path.empty()) return Error{"the name of the output file is empty; give one", ""};
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, ignored))
    return Error{fs::exists(folder, ignored) ? "is not a folder; choose another"
                                             : "the folder does not exist; create it or choose another",
                 folder.string()};
  if (fs::is_directory(path, ignored)) return Error{"is a folder; name a file to write", path};
  // The finished file takes the name's place: a device or a pipe would be gone.
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored))
    return Error{"is a device or pipe, which cannot be replaced by a file; name a file to write", path};
  for (const std::string& input : inputs)
    if (!input.empty() && fs::equivalent(path, input, ignored))
      return Error{"is also read; the output needs another name", path};
  return check_replaceable(path);
}

std::string with_suffix(const std::string& path, const std::string& suffix) {
  fs::path file(path);
  const std::string extension = file.extension().string();
  return file.replace_extension().string() + suffix + extension;
}

Status WholeFiles::add(const std::string& file, std::string_view content) {
  return files_.emplace_back(file).write(content);
}

Status WholeFiles::commit() {
  for (AtomicFile& file : files_)
    if (const Status named = file.commit(); !named) return named;
  return Done{};
}

}  // namespace abrazo
