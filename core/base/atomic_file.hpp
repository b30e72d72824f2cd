#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/limits.hpp"
#include "core/base/result.hpp"

namespace abrazo {

/// Creates an empty file. An existing file of this name is left alone; links, even dangling ones, are not
/// followed. @return whether it was created; if not, errno says why (EEXIST: the name is taken)
bool make_new_file(const std::filesystem::path& path);

/// A file that appears under its name complete or not at all: written beside it under another name, then
/// renamed. The destructor removes a partial file that was not committed.
class AtomicFile {
 public:
  /// Creates the empty partial file under an unpredictable name. If that fails, opening it reports why.
  /// @param extension of the partial file, if its writer depends on it (".mp4")
  explicit AtomicFile(std::filesystem::path target, std::string_view extension = {});
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// The file to write to, in the folder of the target.
  const std::filesystem::path& partial() const { return partial_; }

  /// Writes the content to the partial file.
  Status write(std::string_view content) const;

  /// Renames the finished file to its target, replacing an existing file, whose permissions it gets. An Error
  /// if that is write-protected, or if another program put a link in place of the partial file.
  Status commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path partial_;
  bool committed_ = false;
};

/// An Error if a file is there that its owner does not want to be changed.
Status check_replaceable(const std::filesystem::path& path);

/// Writes `content` to `target`, completely or not at all.
Status write_whole_file(const std::filesystem::path& target, std::string_view content);

/// The content of a file. An Error that names it, also for pipes, devices and files that are larger, or as
/// large as half of the memory that is free.
Result<std::string> read_whole_file(const std::filesystem::path& path,
                                    std::uintmax_t most_bytes = limits::whole_file_bytes);

}  // namespace abrazo
