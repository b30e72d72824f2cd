#pragma once

#include <string>
#include <string_view>

#include "core/base/result.hpp"

namespace abrazo {

/// Opens files that a file refers to: only regular files in its own folder and below.
class FilesBeside {
 public:
  explicit FilesBeside(const std::string& file);
  FilesBeside(const FilesBeside&) = delete;
  FilesBeside& operator=(const FilesBeside&) = delete;
  ~FilesBeside();

  /// The content of such a file. An Error names the file if the path is absolute, contains ".." or is a link,
  /// a pipe, a folder or a device, if the file is larger than 4 GB, or if it does not exist.
  Result<std::string> read(std::string_view name) const;

 private:
  Error refusal(std::string_view name, const std::string& why) const;

  std::string file_;
  int folder_;  ///< -1 when it cannot be opened
};

}  // namespace abrazo
