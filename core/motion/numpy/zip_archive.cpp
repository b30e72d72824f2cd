#include "core/motion/numpy/zip_archive.hpp"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>

#include "core/base/limits.hpp"
#include "core/base/little_endian.hpp"
#include "core/base/text.hpp"

namespace abrazo {

namespace {

constexpr std::string_view entry_mark = "PK\x03\x04", contents_mark = "PK\x01\x02", end_mark = "PK\x05\x06",
                           large_end_mark = "PK\x06\x06", large_locator_mark = "PK\x06\x07";
constexpr std::size_t entry_bytes = 30, contents_bytes = 46, end_bytes = 22, large_locator_bytes = 20,
                      large_end_bytes = 56;
constexpr std::uint64_t see_zip64 = 0xffffffff;

Error damaged_archive(std::string_view where, std::string_view what) {
  return {std::string(what) + "; the archive is cut off or damaged, copy or write it again",
          std::string(where)};
}

/// Where the table of contents is.
struct Contents {
  std::uint64_t at = 0, bytes = 0, entries = 0;
};

Result<Contents> find_contents(std::string_view bytes, std::string_view where) {
  // A comment of up to 65535 bytes may follow the end record.
  const std::size_t end = bytes.rfind(end_mark);
  if (end == std::string_view::npos || bytes.size() - end < end_bytes)
    return damaged_archive(where, "its table of contents, which stands at the end, is missing");
  Contents found{little_endian(bytes, end + 16, 4), little_endian(bytes, end + 12, 4),
                 little_endian(bytes, end + 10, 2)};
  std::uint64_t part = little_endian(bytes, end + 4, 2);
  const bool has_locator =
      end >= large_locator_bytes && bytes.substr(end - large_locator_bytes).starts_with(large_locator_mark);
  if (has_locator) {
    const std::uint64_t at = little_endian(bytes, end - large_locator_bytes + 8, 8);
    if (at > end || end - at < large_end_bytes || !bytes.substr(at).starts_with(large_end_mark))
      return damaged_archive(where, "its ZIP64 end record is not at the stated offset");
    found = {little_endian(bytes, at + 48, 8), little_endian(bytes, at + 40, 8),
             little_endian(bytes, at + 32, 8)};
    part = little_endian(bytes, at + 16, 4);
  }
  if (part != 0 && part != 0xffff)
    return Error{"is one part of several; join them first", std::string(where)};
  if (found.at > end || found.bytes > end - found.at)
    return damaged_archive(where, "its table of contents is stated to be beyond the end of the file");
  if (found.entries > found.bytes / contents_bytes)
    return damaged_archive(where, "its table of contents has fewer entries than it announces");
  return found;
}

/// Sizes and offsets above 4 GiB are in an extra field, in this order.
void read_zip64(std::string_view extra, ZipEntry& entry) {
  while (extra.size() >= 4) {
    const std::uint64_t id = little_endian(extra, 0, 2);
    const std::size_t size = std::min<std::size_t>(little_endian(extra, 2, 2), extra.size() - 4);
    std::string_view field = extra.substr(4, size);
    extra.remove_prefix(4 + size);
    if (id != 1) continue;
    for (std::uint64_t* value : {&entry.size, &entry.stored_size, &entry.header_at}) {
      if (*value != see_zip64 || field.size() < 8) continue;
      *value = little_endian(field, 0, 8);
      field.remove_prefix(8);
    }
  }
}

/// Inflates up to `most` bytes. @return nothing when the data is damaged or ends too early
std::optional<std::string> inflated(std::string_view deflated, std::size_t most) {
  constexpr std::size_t at_once = 1U << 30U;  // zlib counts in 32 bits
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return std::nullopt;
  std::string content(most, '\0');
  std::size_t read = 0, written = 0;
  int state = Z_OK;
  while (state == Z_OK && written < most) {
    const std::size_t room = std::min(most - written, at_once);
    const std::size_t given = std::min(deflated.size() - read, at_once);
    // zlib does not write through next_in.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(deflated.data() + read));
    stream.avail_in = static_cast<uInt>(given);
    stream.next_out = reinterpret_cast<Bytef*>(content.data() + written);
    stream.avail_out = static_cast<uInt>(room);
    state = inflate(&stream, Z_NO_FLUSH);
    read += given - stream.avail_in;
    written += room - stream.avail_out;
    if (state == Z_BUF_ERROR) break;
  }
  inflateEnd(&stream);
  if (written < most && state != Z_STREAM_END) return std::nullopt;
  content.resize(written);
  return content;
}

std::uint32_t crc_of(std::string_view bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

void put(std::string& to, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) to += static_cast<char>(value >> (8U * static_cast<unsigned>(i)) & 0xffU);
}

}  // namespace

Result<ZipArchive> ZipArchive::open(std::string_view bytes, std::string_view where) {
  const auto contents = find_contents(bytes, where);
  if (!contents) return contents.error();
  if (contents->entries > limits::archive_entries)
    return Error{"has " + std::to_string(contents->entries) + " entries; archives of up to " +
                     std::to_string(limits::archive_entries) + " are read",
                 std::string(where)};
  ZipArchive archive;
  archive.bytes_ = bytes;
  archive.where_ = where;
  std::string_view left = bytes.substr(contents->at, contents->bytes);
  std::set<std::string> names;
  for (std::uint64_t n = 0; n < contents->entries; ++n) {
    if (left.size() < contents_bytes || !left.starts_with(contents_mark))
      return damaged_archive(where,
                             "entry " + std::to_string(n + 1) + " of its table of contents is damaged");
    const std::size_t name = little_endian(left, 28, 2), extra = little_endian(left, 30, 2),
                      comment = little_endian(left, 32, 2);
    if (left.size() - contents_bytes < name + extra + comment)
      return damaged_archive(where,
                             "entry " + std::to_string(n + 1) + " of its table of contents is cut off");
    ZipEntry entry;
    entry.name = left.substr(contents_bytes, name);
    entry.crc = static_cast<std::uint32_t>(little_endian(left, 16, 4));
    entry.stored_size = little_endian(left, 20, 4);
    entry.size = little_endian(left, 24, 4);
    entry.header_at = little_endian(left, 42, 4);
    read_zip64(left.substr(contents_bytes + name, extra), entry);
    const std::uint64_t flags = little_endian(left, 8, 2), method = little_endian(left, 10, 2);
    left.remove_prefix(contents_bytes + name + extra + comment);
    if ((flags & 1U) != 0)
      return Error{in_quotes(entry.name) + " is encrypted; write the archive without a password",
                   std::string(where)};
    if (method != 0 && method != Z_DEFLATED)
      return Error{in_quotes(entry.name) + " is compressed by method " + std::to_string(method) +
                       "; only stored and deflated ones are read (np.savez, np.savez_compressed)",
                   std::string(where)};
    entry.deflated = method == Z_DEFLATED;
    if (entry.deflated && entry.size / limits::deflate_ratio > entry.stored_size)
      return damaged_archive(where, in_quotes(entry.name) + " announces " + std::to_string(entry.size) +
                                        " bytes, more than its " + std::to_string(entry.stored_size) +
                                        " stored bytes can give");
    if (!names.insert(entry.name).second)
      return damaged_archive(where, "holds " + in_quotes(entry.name) + " twice");
    archive.entries_.push_back(std::move(entry));
  }
  return archive;
}

Result<std::string_view> ZipArchive::stored(const ZipEntry& entry) const {
  const Error outside =
      damaged_archive(where_, in_quotes(entry.name) + " is stated to be beyond the end of the file");
  if (entry.header_at > bytes_.size() || bytes_.size() - entry.header_at < entry_bytes) return outside;
  const std::string_view here = bytes_.substr(entry.header_at);
  if (!here.starts_with(entry_mark))
    return damaged_archive(where_, in_quotes(entry.name) + " does not begin at the stated offset");
  // The lengths of name and extra field may differ from those in the table of contents.
  const std::size_t before = entry_bytes + little_endian(here, 26, 2) + little_endian(here, 28, 2);
  if (before > here.size() || here.size() - before < entry.stored_size) return outside;
  if (!entry.deflated && entry.stored_size != entry.size)
    return damaged_archive(where_, in_quotes(entry.name) + " is stored, but with two different sizes");
  return here.substr(before, entry.stored_size);
}

Result<std::string> ZipArchive::beginning_of(const ZipEntry& entry, std::size_t most) const {
  const auto bytes = stored(entry);
  if (!bytes) return bytes.error();
  const std::size_t wanted = std::min<std::uint64_t>(most, entry.size);
  if (!entry.deflated) return std::string(bytes->substr(0, wanted));
  auto content = inflated(*bytes, wanted);
  if (!content) return damaged_archive(where_, in_quotes(entry.name) + " cannot be inflated");
  return std::move(*content);
}

Result<std::string> ZipArchive::content_of(const ZipEntry& entry) const {
  auto content = beginning_of(entry, std::numeric_limits<std::size_t>::max());
  if (!content) return content.error();
  if (content->size() != entry.size)
    return damaged_archive(where_, in_quotes(entry.name) + " is shorter than the " +
                                       std::to_string(entry.size) + " bytes it announces");
  if (crc_of(*content) != entry.crc)
    return damaged_archive(where_, in_quotes(entry.name) + " has another checksum (CRC) than was written");
  return content;
}

Result<std::string> write_zip(std::span<const ZipContent> files) {
  constexpr std::uint64_t first_day = 1U << 5U | 1U;  // 1 January 1980 as MS-DOS has it
  constexpr int version = 20;
  std::string archive, contents;
  for (const ZipContent& file : files) {
    if (file.bytes.size() + archive.size() >= see_zip64)
      return Error{"would be larger than 4 GiB; write fewer frames at once", ""};
    const std::uint64_t at = archive.size();
    std::string common;  // of the entry's own header and of the table of contents
    put(common, version, 2), put(common, 0, 2), put(common, 0, 2), put(common, 0, 2),
        put(common, first_day, 2);
    put(common, crc_of(file.bytes), 4), put(common, file.bytes.size(), 4), put(common, file.bytes.size(), 4);
    put(common, file.name.size(), 2), put(common, 0, 2);
    archive.append(entry_mark).append(common).append(file.name).append(file.bytes);
    contents.append(contents_mark);
    put(contents, version, 2);
    contents.append(common);
    put(contents, 0, 8), put(contents, 0, 2), put(contents, at, 4);
    contents.append(file.name);
  }
  const std::uint64_t at = archive.size();
  archive += contents;
  archive.append(end_mark);
  put(archive, 0, 4), put(archive, files.size(), 2), put(archive, files.size(), 2);
  put(archive, contents.size(), 4), put(archive, at, 4), put(archive, 0, 2);
  return archive;
}

}  // namespace abrazo
