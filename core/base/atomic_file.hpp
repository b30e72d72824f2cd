#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.hpp"

namespace abrazo {

/// A file that appears under its name whole or not at all: written beside it under another name, then
/// renamed. Not committed when it goes out of scope: the partial file is removed.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path target);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Where to write meanwhile (same folder as the target).
  const std::filesystem::path& partial() const { return partial_; }

  /// Writes the whole content beside the target.
  Status write(std::string_view content) const;

  /// Moves the finished file to its name, replacing what was there.
  Status commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path partial_;
  bool committed_ = false;
};

/// Writes `content` to `target`, whole or not at all.
Status write_whole_file(const std::filesystem::path& target, std::string_view content);

/// The content of a file, or an Error that names it: also for a pipe or a device, and for more than 4 GB.
Result<std::string> read_whole_file(const std::filesystem::path& path);

}  // namespace abrazo
