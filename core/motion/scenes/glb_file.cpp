#include "core/motion/scenes/glb_file.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/base/limits.hpp"
#include "core/base/little_endian.hpp"

namespace abrazo {

namespace {

using Json = nlohmann::json;

constexpr std::uint64_t glb_magic = 0x46546C67, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
constexpr std::size_t header_bytes = 12, chunk_header_bytes = 8;
constexpr std::size_t most_nodes = 100'000;

void append_number(std::string& file, std::uint64_t number) {
  for (int byte = 0; byte < 4; ++byte) file += static_cast<char>(number >> (8 * byte) & 0xFFU);
}

void append_chunk(std::string& file, std::uint64_t kind, std::string content, char filler) {
  content.resize((content.size() + 3) / 4 * 4, filler);
  append_number(file, content.size());
  append_number(file, kind);
  file += content;
}

}  // namespace

Result<GlbFile> parse_glb(std::string_view bytes, const std::string& where) {
  const Error wrong{"is no GLB or VRM file (glTF 2.0, binary), or is cut off", where};
  if (bytes.size() < header_bytes + chunk_header_bytes || little_endian(bytes, 0, 4) != glb_magic ||
      little_endian(bytes, 4, 4) != 2 || little_endian(bytes, 8, 4) > bytes.size())
    return wrong;
  GlbFile glb;
  for (std::size_t at = header_bytes; at + chunk_header_bytes <= bytes.size();) {
    const std::size_t length = little_endian(bytes, at, 4);
    const std::uint64_t kind = little_endian(bytes, at + 4, 4);
    at += chunk_header_bytes;
    if (length > bytes.size() - at) return wrong;
    const std::string_view content = bytes.substr(at, length);
    if (kind == json_chunk && glb.json.is_null()) {
      if (const char* beyond = json_beyond_bounds(content)) return Error{beyond, where};
      glb.json = Json::parse(content, nullptr, false);
    } else if (kind == binary_chunk && glb.binary.empty()) {
      glb.binary = content;
    }
    at += length;
  }
  if (!glb.json.is_object() || !glb.json.contains("nodes") || !glb.json["nodes"].is_array() ||
      glb.json["nodes"].size() > most_nodes)
    return wrong;
  return glb;
}

Result<std::string> glb_text(const GlbFile& glb, const std::string& where) {
  std::string chunks;
  append_chunk(chunks, json_chunk, glb.json.dump(-1, ' ', false, Json::error_handler_t::replace), ' ');
  append_chunk(chunks, binary_chunk, glb.binary, '\0');
  const std::size_t bytes = header_bytes + chunks.size();
  if (bytes > std::numeric_limits<std::uint32_t>::max())
    return Error{"the character with its motion is longer than a GLB file can be (4 GB)", where};
  std::string file = "glTF";
  append_number(file, 2);
  append_number(file, bytes);
  return file + chunks;
}

}  // namespace abrazo
