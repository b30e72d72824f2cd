#include "core/video/file_kind.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <set>
#include <string_view>
#include <system_error>

#include "core/video/mp4_index.hpp"

namespace abrazo {
namespace {

std::string why_no_mp4(std::ifstream& stream, std::uint64_t size) {
  const std::string index = mp4_index(stream, size);
  if (index.empty())
    return "is an MP4 without its index (\"moov\"): it was cut off before it was finished; record or copy it "
           "again, or have it repaired by a program like untrunc";
  if (index.find("vide") == std::string::npos && index.find("soun") != std::string::npos)
    return "holds sound and no pictures; choose the file with the pictures";
  return "is an MP4 whose pictures cannot be read: damaged, or in a coding that is not known here; convert "
         "it "
         "to H.264 in an .mp4";
}

struct Signature {
  std::size_t at;
  std::string_view bytes;
  const char* what;
};
constexpr std::string_view sound = "holds sound and no pictures; choose the file with the pictures";
constexpr std::string_view others =
    "is a list of other files or addresses, which are not opened; choose the video itself";
constexpr std::array<Signature, 17> signatures = {{
    {0, "#EXTM3U", others.data()},
    {0, "ffconcat", others.data()},
    {0, "v=0", others.data()},
    {0, "<?xml", others.data()},
    {0, "<MPD", others.data()},
    {8, "WAVE", sound.data()},
    {0, "ID3", sound.data()},
    {0, "fLaC", sound.data()},
    {0, "#!AMR", sound.data()},
    {0, "SQLite format 3", "is a session or another database, not a video"},
    {0, "\x89HDF", "is a motion library or another HDF5 file, not a video"},
    {0, "%PDF", "is a PDF document, not a video"},
    {0, "PK\x03\x04", "is a ZIP archive, not a video; unpack it first"},
    {0, "HIERARCHY", "is a BVH motion, not a video"},
    {0, "glTF", "is a glTF scene, not a video"},
    {0, "RIFF",
     "is an AVI or another RIFF file whose pictures cannot be read: damaged, or in an unknown coding"},
    {0, "\x1A\x45\xDF\xA3",
     "is a Matroska or WebM file without pictures that can be read: damaged, only sound, "
     "or in an unknown coding"},
}};

bool is_text(std::string_view bytes) {
  for (const char c : bytes)
    if (static_cast<unsigned char>(c) < 9) return false;
  return true;
}

/// A container that is read: what it begins with, and FFmpeg's name of what reads it. Each is binary and
/// holds its pictures itself; none names other files that FFmpeg would open.
struct Container {
  std::size_t at;
  std::string_view bytes;
  const char* demuxer;
};
constexpr const char* mp4 = "mov,mp4,m4a,3gp,3g2,mj2";
constexpr std::array<Container, 17> containers = {{
    {4, "ftyp", mp4},
    {4, "moov", mp4},
    {4, "mdat", mp4},
    {4, "wide", mp4},
    {4, "free", mp4},
    {4, "skip", mp4},
    {4, "pnot", mp4},
    {0, "\x1A\x45\xDF\xA3", "matroska,webm"},
    {8, "AVI ", "avi"},  // after RIFF and a size
    {0, {"\0\0\1\xBA", 4}, "mpeg"},
    {0, "\x30\x26\xB2\x75\x8E\x66\xCF\x11", "asf"},
    {0, "FLV\1", "flv"},
    {0, "OggS", "ogg"},
    {0, "\x06\x0E\x2B\x34\x02\x05\x01\x01\x0D\x01\x02", "mxf"},
    {0, "YUV4MPEG2 ", "yuv4mpegpipe"},
    {0, {"\0\0\1\xB3", 4}, "mpegvideo"},
    {0, "\xFF\xD8\xFF", "mjpeg"},
}};
constexpr const char* transport_stream = "mpegts";
constexpr std::array<std::array<std::size_t, 2>, 2> packets = {
    {{0, 188}, {4, 192}}};  // first sync byte, and how far apart

bool is_transport_stream(std::string_view head) {
  return std::any_of(packets.begin(), packets.end(), [&](const auto& packet) {
    for (std::size_t i = 0; i < 4; ++i)
      if (const std::size_t at = packet[0] + i * packet[1]; at >= head.size() || head[at] != 0x47)
        return false;
    return true;
  });
}

constexpr std::size_t looked_at = 1024;

}  // namespace

bool is_known_container(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string head = bytes_at(stream, 0, looked_at);
  return is_transport_stream(head) ||
         std::any_of(containers.begin(), containers.end(), [&](const Container& known) {
           return head.size() > known.at && std::string_view(head).substr(known.at).starts_with(known.bytes);
         });
}

std::string known_demuxers() {
  std::set<std::string_view> names = {transport_stream};
  for (const Container& known : containers) names.insert(known.demuxer);
  return fmt::format("{}", fmt::join(names, ","));
}

std::string why_no_video(const std::filesystem::path& file) {
  std::error_code failure;
  if (!std::filesystem::exists(file, failure)) return "does not exist; check the path";
  if (std::filesystem::is_directory(file, failure)) return "is a folder; choose a video file in it";
  if (!std::filesystem::is_regular_file(file, failure))
    return "cannot be read: it is a device or a pipe, no file";
  const std::uint64_t size = std::filesystem::file_size(file, failure);
  std::ifstream stream(file, std::ios::binary);
  if (failure || !stream) return "cannot be read; check its permissions";
  if (size == 0) return "is empty (0 bytes); it was not copied or recorded to its end";
  const std::string head = bytes_at(stream, 0, 64);
  const std::string_view fourth = std::string_view(head).substr(std::min<std::size_t>(4, head.size()), 4);
  if (fourth == "ftyp" || fourth == "moov" || fourth == "mdat" || fourth == "wide" || fourth == "free")
    return why_no_mp4(stream, size);
  for (const Signature& known : signatures)
    if (head.size() > known.at && std::string_view(head).substr(known.at).starts_with(known.bytes))
      return known.what;
  if (is_text(head)) return "is a text, not a video";
  return "is not a video that can be read: of no known kind, or damaged at its beginning; convert it to "
         "H.264 "
         "in an .mp4";
}

}  // namespace abrazo
