#include "core/session/file/data_reference.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>

#include "core/base/checksum.hpp"

namespace abrazo {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t whole_up_to = std::uint64_t{64} << 20;
/// Of a larger file so much of its begin, its middle and its end.
constexpr std::uint64_t sample_bytes = std::uint64_t{4} << 20;

constexpr std::array<std::string_view, 8> use_texts = {"library", "manifest",   "motion",    "skeleton",
                                                       "video",   "intrinsics", "joint map", "take file"};

void add_bytes(std::span<const char> bytes, ContentHash& hash) {
  std::size_t at = 0;
  for (; at + 8 <= bytes.size(); at += 8) {
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < 8; ++i)
      word |= std::uint64_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
    hash.add(word);
  }
  std::uint64_t rest = 0;
  for (; at < bytes.size(); ++at) rest = (rest << 8) | static_cast<unsigned char>(bytes[at]);
  hash.add(rest);
}

bool add_part(std::ifstream& file, std::uint64_t from, std::uint64_t bytes, ContentHash& hash) {
  std::vector<char> buffer(std::size_t{1} << 20);
  file.seekg(static_cast<std::streamoff>(from));
  while (bytes > 0 && file) {
    const auto wanted = static_cast<std::streamsize>(std::min<std::uint64_t>(bytes, buffer.size()));
    file.read(buffer.data(), wanted);
    const std::streamsize got = file.gcount();
    if (got <= 0) return false;
    add_bytes({buffer.data(), static_cast<std::size_t>(got)}, hash);
    bytes -= static_cast<std::uint64_t>(got);
  }
  return bytes == 0;
}

Result<std::string> hash_of(const fs::path& path, std::uint64_t bytes) {
  std::ifstream file(path, std::ios::binary);
  ContentHash hash;
  hash.add(bytes);
  bool read = file.good();
  if (bytes <= whole_up_to) {
    read = read && add_part(file, 0, bytes, hash);
  } else {
    for (const std::uint64_t from : {std::uint64_t{0}, (bytes - sample_bytes) / 2, bytes - sample_bytes})
      read = read && add_part(file, from, sample_bytes, hash);
  }
  if (!read) return Error{"cannot be read; check who may read it", path.string()};
  return hash.text();
}

std::string absolute(const fs::path& path) {
  std::error_code failure;
  return fs::absolute(path, failure).lexically_normal().string();
}

fs::path folder_of_session(const std::string& session_path) {
  return fs::path(absolute(session_path)).parent_path();
}

bool is_file(const fs::path& path) {
  std::error_code failure;
  return fs::is_regular_file(path, failure);
}

/// A reference from an untrusted session can name anything; only regular files are opened.
bool has_content(const fs::path& path, const DataReference& reference) {
  std::error_code failure;
  const std::uint64_t bytes = fs::file_size(path, failure);
  if (failure || bytes != reference.bytes) return false;
  const auto hash = hash_of(path, bytes);
  return hash && *hash == reference.hash;
}

}  // namespace

std::string_view text_of(DataReference::Use use) {
  return use_texts[static_cast<std::size_t>(use)];
}

Result<DataReference::Use> parse_data_use(std::string_view text) {
  for (std::size_t i = 0; i < use_texts.size(); ++i)
    if (use_texts[i] == text) return static_cast<DataReference::Use>(i);
  return Error{"a file is for '" + std::string(text) + "', which this program does not know", {}};
}

DataReference unread_reference(DataReference::Use use, const std::string& file) {
  DataReference reference;
  reference.use = use;
  reference.absolute_path = absolute(file);
  return reference;
}

Result<DataReference> reference_to(const std::string& file, DataReference::Use use,
                                   const std::string& session_path) {
  if (!is_file(file)) return Error{"there is no such file", file};
  DataReference reference;
  reference.use = use;
  reference.absolute_path = absolute(file);
  std::error_code failure;
  const fs::path relative =
      fs::path(reference.absolute_path).lexically_relative(folder_of_session(session_path));
  if (!session_path.empty()) reference.relative_path = relative.generic_string();
  reference.bytes = fs::file_size(file, failure);
  if (failure) return Error{"cannot be read (" + failure.message() + ")", file};
  auto hash = hash_of(file, reference.bytes);
  if (!hash) return hash.error();
  reference.hash = std::move(*hash);
  return reference;
}

FoundData find_data(const DataReference& reference, const std::string& session_path) {
  FoundData found;
  const auto look = [&found](const fs::path& path) {
    const std::string place = path.lexically_normal().string();
    if (std::ranges::find(found.looked, place) == found.looked.end()) found.looked.push_back(place);
  };
  if (!reference.relative_path.empty() && !session_path.empty())
    look(folder_of_session(session_path) / reference.relative_path);
  if (!reference.absolute_path.empty()) look(reference.absolute_path);
  for (const std::string& place : found.looked) {
    if (!is_file(place)) continue;
    const bool is_same = reference.hash.empty() || has_content(place, reference);
    if (is_same || found.state == FoundData::State::Missing) found.path = place;
    found.state = is_same ? FoundData::State::Found : FoundData::State::Changed;
    if (is_same) break;
  }
  return found;
}

std::map<std::size_t, std::string> relocated(const std::vector<DataReference>& data, std::size_t pointed_out,
                                             const std::string& path) {
  std::map<std::size_t, std::string> found;
  if (pointed_out >= data.size()) return found;
  const fs::path old_folder = fs::path(data[pointed_out].absolute_path).parent_path();
  const fs::path new_folder = fs::path(absolute(path)).parent_path();
  for (std::size_t i = 0; i < data.size(); ++i) {
    if (i == pointed_out || data[i].absolute_path.empty()) continue;
    const fs::path way = fs::path(data[i].absolute_path).lexically_relative(old_folder);
    if (way.empty()) continue;
    const std::string there = (new_folder / way).lexically_normal().string();
    if (is_file(there)) found[i] = there;
  }
  return found;
}

}  // namespace abrazo
