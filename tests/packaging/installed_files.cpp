#include "tests/packaging/installed_files.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace abrazo::test {

namespace fs = std::filesystem;

fs::path installed(const std::string& name) {
  return fs::path(ABRAZO_INSTALLED) / name;
}

std::vector<fs::path> installed_files(const std::string& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(installed(folder)))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string program_at(const std::string& name) {
  for (const char* folder : {"/usr/local/bin", "/usr/bin", "/bin"})
    if (const fs::path file = fs::path(folder) / name; fs::exists(file)) return file.string();
  return {};
}

}  // namespace abrazo::test
