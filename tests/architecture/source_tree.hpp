#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace abrazo::test {

/// A text file of the repository.
struct SourceFile {
  std::string path;  ///< from the repository's root, with '/'
  std::vector<std::string> lines;

  bool is_cpp() const { return path.ends_with(".hpp") || path.ends_with(".cpp") || path.ends_with(".h"); }
  bool is_header() const { return path.ends_with(".hpp") || path.ends_with(".h"); }
  bool is_under(std::string_view folder) const { return path.starts_with(folder); }  ///< folder ends in '/'
};

/// One #include of a file.
struct Include {
  std::string path;  ///< as written between the quotes or brackets
  int line = 0;      ///< 1-based
};

/// One link of a document to another file of the repository.
struct DocumentLink {
  std::string target;  ///< from the repository's root, without an anchor
  int line = 0;        ///< 1-based
};

SourceFile source_file(std::string path, std::string_view text);

std::vector<Include> includes_of(const SourceFile& file);

/// Relative links and pictures of a Markdown file; code blocks and addresses of the web are left out.
std::vector<DocumentLink> links_of(const SourceFile& document);

/// Every text file of the fixed folders and of the root, sorted by path. Pictures and other binary files are
/// left out.
std::vector<SourceFile> read_source_tree(const std::filesystem::path& root);

}  // namespace abrazo::test
