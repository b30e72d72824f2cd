#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.hpp"

namespace abrazo {

/// Makes an empty file, and nothing else: what has the name already, a link to nowhere too, is left alone and
/// not followed. @return whether it was made; if not, errno says why (EEXIST: the name is taken)
bool make_new_file(const std::filesystem::path& path);

/// A file that appears under its name whole or not at all: written beside it under another name, then
/// renamed. Not committed when it goes out of scope: the partial file is removed.
class AtomicFile {
 public:
  /// Makes the partial file, empty, under a name that nobody can foresee. Where it cannot be made, whoever
  /// opens it finds out why.
  /// @param extension  that the partial file ends in, where its writer goes by that (".mp4")
  explicit AtomicFile(std::filesystem::path target, std::string_view extension = {});
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Where to write meanwhile: to this file, in the folder of the target.
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
