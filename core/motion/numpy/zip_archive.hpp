#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo {

/// One file of a ZIP archive, from the central directory at its end.
struct ZipEntry {
  std::string name;
  std::uint64_t size = 0;         ///< of its content [bytes]
  std::uint64_t stored_size = 0;  ///< in the archive [bytes]
  std::uint64_t header_at = 0;    ///< offset of its local header
  std::uint32_t crc = 0;
  bool deflated = false;
};

/// A ZIP archive in memory (PKWARE, APPNOTE 6.3), stored or deflated, with or without ZIP64, as NumPy writes
/// them. The bytes must outlive it.
class ZipArchive {
 public:
  /// @return an Error if the central directory is missing, damaged or lists unsupported entries: encrypted,
  /// other compression, several parts
  static Result<ZipArchive> open(std::string_view bytes, std::string_view where);

  const std::vector<ZipEntry>& entries() const { return entries_; }

  /// The first bytes of an entry, at most `most`, unchecked: to recognise the content before memory is
  /// allocated.
  Result<std::string> beginning_of(const ZipEntry& entry, std::size_t most) const;

  /// The whole content; an Error if length or checksum (CRC-32) do not match.
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

/// An archive with these files, uncompressed, dated 1 January 1980: equal content gives an equal archive.
Result<std::string> write_zip(std::span<const ZipContent> files);

}  // namespace abrazo
