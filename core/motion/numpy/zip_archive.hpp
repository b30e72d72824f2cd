#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo {

/// One file of a ZIP archive, as the table of contents at its end has it.
struct ZipEntry {
  std::string name;
  std::uint64_t size = 0;         ///< of its content [bytes]
  std::uint64_t stored_size = 0;  ///< in the archive [bytes]
  std::uint64_t header_at = 0;    ///< byte of the archive at which its own header begins
  std::uint32_t crc = 0;
  bool deflated = false;
};

/// A ZIP archive in memory (PKWARE, APPNOTE 6.3), stored or deflated, with or without ZIP64: what NumPy
/// writes. The bytes it was opened on have to outlive it.
class ZipArchive {
 public:
  /// @return an Error when the table of contents is missing, damaged or names what cannot be read: encrypted,
  /// of another compression, in several parts
  static Result<ZipArchive> open(std::string_view bytes, std::string_view where);

  const std::vector<ZipEntry>& entries() const { return entries_; }

  /// The first bytes of an entry, at most `most`, unchecked: enough to see what it is before room is made
  /// for it.
  Result<std::string> beginning_of(const ZipEntry& entry, std::size_t most) const;

  /// The whole content; an Error when its length or its checksum (CRC-32) is another than was written.
  Result<std::string> content_of(const ZipEntry& entry) const;

 private:
  Result<std::string_view> stored(const ZipEntry& entry) const;

  std::string_view bytes_;
  std::string where_;
  std::vector<ZipEntry> entries_;
};

struct ZipContent {
  std::string name;
  std::string bytes;
};

/// An archive with these files, stored as they are, dated 1 January 1980: the same content is the same
/// archive.
Result<std::string> write_zip(std::span<const ZipContent> files);

}  // namespace abrazo
