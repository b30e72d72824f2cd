#pragma once

#include <string>

namespace abrazo {

/// Remembers the file behind a path, to detect that it is deleted or moved while in use. Does not read or
/// lock the file.
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

 private:
  std::string path_;
  int descriptor_ = -1;
};

}  // namespace abrazo
