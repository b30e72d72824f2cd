#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace abrazo {

/// Remembers the file behind a path, to detect that it is deleted, moved or written by others while in use.
/// Does not read or lock the file.
class WatchedFile {
 public:
  /// @param path of an existing file; a missing one counts as deleted
  explicit WatchedFile(std::string path);
  WatchedFile(WatchedFile&& other) noexcept;
  WatchedFile& operator=(WatchedFile&& other) noexcept;
  ~WatchedFile();

  enum class State {
    There,
    Deleted,  ///< it has no name any more: data written to it is lost when it is closed
    Moved     ///< it has another name, or another file has taken its name
  };
  State state() const;
  /// When the file was last written under any name [ns since 1970]; none if unknown. Two writes within one
  /// tick of the kernel's clock, some 4 ms, have the same time.
  std::optional<std::int64_t> written_ns() const;

 private:
  std::string path_;
  int descriptor_ = -1;
};

}  // namespace abrazo
