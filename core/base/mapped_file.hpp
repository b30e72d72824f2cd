#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "core/base/result.hpp"

namespace abrazo {

/// A file's bytes as memory, read page by page as they are touched; shared by all who map it. Never writes.
/// Whoever replaces the file by renaming another to its name, or deletes it, leaves the mapping as it was.
/// Whoever cuts it short takes pages from under it: they read as zeros from then on, and the file says so
/// (without this the system would end the program, SIGBUS). Whoever writes into the file changes what is
/// read here, at any moment: what is read must be checked as it is used.
class MappedFile {
 public:
  /// @param descriptor  of a file open for reading; may be closed afterwards
  /// @param shown       name for messages
  static Result<std::shared_ptr<const MappedFile>> map(int descriptor, const std::string& shown);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::span<const std::byte> bytes() const { return bytes_; }
  /// A page could not be read when it was touched: the file was cut short, or its disk failed.
  bool lost_pages() const;
  /// The file was written to, cut short or grown since it was mapped. Asks the system: some hundred
  /// nanoseconds.
  bool was_changed() const;

 private:
  /// What changes with a file's content.
  struct State {
    std::int64_t bytes = 0, changed_s = 0, changed_ns = 0;
    bool operator==(const State&) const = default;
  };

  MappedFile(std::span<const std::byte> bytes, std::size_t watch, int descriptor)
      : bytes_(bytes), watch_(watch), descriptor_(descriptor), state_(state_of(descriptor)) {}
  static State state_of(int descriptor);

  std::span<const std::byte> bytes_;
  std::size_t watch_;  ///< row of the table that the signal handler reads
  int descriptor_;     ///< its own
  State state_;        ///< when it was mapped
};

}  // namespace abrazo
