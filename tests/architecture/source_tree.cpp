#include "tests/architecture/source_tree.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <regex>
#include <stdexcept>
#include <utility>

namespace abrazo::test {
namespace {

namespace fs = std::filesystem;

constexpr std::array folders = {"core", "widgets", "app",   "resources", "tests",   "data",
                                "docs", ".ci",     "cmake", "packaging", "examples"};

void add_if_text(std::vector<SourceFile>& files, const fs::path& root, const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) throw std::runtime_error("cannot read " + path.string());
  if (text.find('\0') != std::string::npos) return;
  files.push_back(source_file(path.lexically_relative(root).generic_string(), text));
}

}  // namespace

SourceFile source_file(std::string path, std::string_view text) {
  SourceFile file{std::move(path), {}};
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    file.lines.emplace_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return file;
}

std::vector<Include> includes_of(const SourceFile& file) {
  static const std::regex directive(R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"])re");
  std::vector<Include> includes;
  int number = 0;
  for (const std::string& line : file.lines) {
    ++number;
    std::smatch match;
    if (std::regex_search(line, match, directive)) includes.push_back({match[1], number});
  }
  return includes;
}

std::vector<DocumentLink> links_of(const SourceFile& document) {
  static const std::regex link(R"re(\]\(([^)#\s]+)(#[^)]*)?\))re");
  const fs::path folder = fs::path(document.path).parent_path();
  std::vector<DocumentLink> links;
  bool in_code = false;
  int number = 0;
  for (const std::string& line : document.lines) {
    ++number;
    if (line.starts_with("```")) in_code = !in_code;
    if (in_code) continue;
    for (std::sregex_iterator match(line.begin(), line.end(), link), end; match != end; ++match) {
      const std::string target = (*match)[1];
      if (target.find("://") != std::string::npos) continue;
      links.push_back({(folder / target).lexically_normal().generic_string(), number});
    }
  }
  return links;
}

std::vector<SourceFile> read_source_tree(const fs::path& root) {
  std::vector<SourceFile> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(root)) {
    const bool is_of_git = entry.path().filename() == ".git";  // a file in a further working tree
    if (entry.is_regular_file() && !is_of_git) add_if_text(files, root, entry.path());
  }
  for (const char* folder : folders) {
    if (!fs::exists(root / folder)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.is_regular_file()) add_if_text(files, root, entry.path());
    }
  }
  std::ranges::sort(files, {}, &SourceFile::path);
  return files;
}

}  // namespace abrazo::test
