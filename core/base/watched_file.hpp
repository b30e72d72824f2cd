#pragma once

#include <string>

namespace abrazo {

/// Remembers which file a name meant, to notice when it is deleted or moved while it is in use. Keeps
/// the file from nothing: it is neither read nor locked by this.
class WatchedFile {
 public:
  /// @param path  of a file that is there; one that is not counts as deleted
  explicit WatchedFile(std::string path);
  WatchedFile(WatchedFile&& other) noexcept;
  WatchedFile& operator=(WatchedFile&& other) noexcept;
  ~WatchedFile();

  enum class State {
    There,
    Deleted,  ///< it has no name any more: what is written to it is gone when it is closed
    Moved     ///< it has another name, or another file has taken its name
  };
  State state() const;

 private:
  std::string path_;
  int descriptor_ = -1;
};

}  // namespace abrazo
