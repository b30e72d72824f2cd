#pragma once

#include <string>
#include <string_view>

#include "core/base/result.hpp"

namespace abrazo {

/// The folder of a file, for what the file names: regular files in that folder and below, and nothing else.
class FilesBeside {
 public:
  explicit FilesBeside(const std::string& file);
  FilesBeside(const FilesBeside&) = delete;
  FilesBeside& operator=(const FilesBeside&) = delete;
  ~FilesBeside();

  /// The content of one of them. An Error that names the file for an absolute path, "..", a link, a pipe, a
  /// folder, a device, for more than 4 GB, and when it is not there.
  Result<std::string> read(std::string_view name) const;

 private:
  Error refusal(std::string_view name, const std::string& why) const;

  std::string file_;
  int folder_;  ///< -1 when it cannot be opened
};

}  // namespace abrazo
