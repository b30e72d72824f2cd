#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "core/base/result.hpp"

namespace abrazo {

/// A read-only memory mapping of a file, loaded page by page on access. Replacing the file by a rename, or
/// deleting it, does not affect the mapping. Truncating it removes pages: they then read as zeros, and
/// lost_pages() is true (otherwise the system would end the program with SIGBUS). Writing to the file changes
/// the mapped bytes at any moment, so data must be checked on use.
class MappedFile {
 public:
  /// @param descriptor  of a file open for reading; may be closed afterwards
  /// @param shown       name for messages
  static Result<std::shared_ptr<const MappedFile>> map(int descriptor, const std::string& shown);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::span<const std::byte> bytes() const { return bytes_; }
  /// Whether a page could not be read: the file was truncated, or its disk failed.
  bool lost_pages() const;
  /// Whether the file was written, truncated or extended since it was mapped. A system call: some hundred
  /// nanoseconds.
  bool was_changed() const;

 private:
  /// Properties that change with a file's content.
  struct State {
    std::int64_t bytes = 0, changed_s = 0, changed_ns = 0;
    bool operator==(const State&) const = default;
  };

  MappedFile(std::span<const std::byte> bytes, std::size_t watch, int descriptor)
      : bytes_(bytes), watch_(watch), descriptor_(descriptor), state_(state_of(descriptor)) {}
  static State state_of(int descriptor);

  std::span<const std::byte> bytes_;
  std::size_t watch_;  ///< row in the signal handler's table
  int descriptor_;     ///< owned
  State state_;        ///< at the time of mapping
};

}  // namespace abrazo
